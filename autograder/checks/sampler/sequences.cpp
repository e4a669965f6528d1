// 6.3: dimensions of the Halton and the Sobol' sequence, in blocks of eight.

#include "checks/sampler/sequences.hpp"

#include <map>
#include <numeric>

#include "checks/sampler/relations.hpp"
#include "checks/sampler/samplers.hpp"
#include "checks/support/catch.hpp"

namespace mc::checks {
namespace {

/// Is the column this dimension, in the sequence's own order? Beyond the first eight too.
bool is_dimension(const std::string& kind, View x, unsigned d) {
  if (kind == "sobol") return is_scrambled_sobol(x, d);
  return is_scrambled_halton(x, first_primes[d]);
}

/// Each coordinate of the first block is a dimension of its own, one after the other.
void expect_first_block(const std::string& kind, const Columns& got, const Uses& uses,
                        const std::string& what, const std::string& because) {
  const auto places = places_of(uses);
  for (std::size_t c = 0; c < got.dims && places[c].block == 0; ++c) {
    const unsigned d = places[c].dimension;
    if (is_dimension(kind, got[c], d)) continue;
    std::string hint = "is it the sequence from index 0, in its own order, a sample a point?";
    for (unsigned other = 0; other < 10; ++other) {  // in larger primes few digits come twice
      if (!is_dimension(kind, got[c], other)) continue;
      hint = fmt::format(
          "this is dimension {}: each sample dimension takes the next one of the sequence when it "
          "is first asked for, a next2() the next two",
          other);
      break;
    }
    expect_that(false, fmt::format("{}: coordinate {} is not dimension {}", got.call, c, d), what,
                because, hint);
  }
  pass();
}

/// Uses whose first eight dimensions are asked for in several ways.
const std::vector<Uses> ways{{1, 2, 1, 2, 2}, {2, 2, 2, 2}, {1, 1, 1, 1, 1, 1, 1, 1}};

/// Not a digital shift, in one of these columns at least. In one column of 64 nested flips agree by
/// chance with probability 2^-57, and with a hash of few random bits still not more than once in 8.
void expect_nested(const std::string& call, const std::vector<View>& columns,
                   std::span<const std::uint32_t> words, const std::string& which) {
  bool is_plain = true;  // that is seen where seeds are compared
  for (const View x : columns) {
    if (!is_digital_shift(x, words)) return pass();
    is_plain = is_plain && x[0] == 0;
  }
  if (is_plain) return pass();
  expect_that(false, fmt::format("{}: {} is a digital shift, with every seed", call, which),
              "nested scrambling (5.8)",
              "nested scrambling flips a bit or not depending on the bits before it; a digital "
              "shift, or digits permuted in base 2, does so for all points alike",
              "owen_scramble of lab 5, with a seed for each dimension");
}

std::vector<std::uint32_t> sobol_words(unsigned d, std::size_t n) {
  const auto directions = sobol_directions(d);
  std::vector<std::uint32_t> words;
  for (std::size_t i = 0; i < n; ++i) words.push_back(sobol_word(directions, i));
  return words;
}

CHECK_CASE("6.3 the first dimensions of sobol are Sobol' dimensions",
           "[6.3][main][points:4][needs:5]") {
  Rng rng = check_rng();
  for (const Uses& uses : ways) {
    expect_first_block("sobol", columns_of("sobol", 61, {fresh_seed(rng)}, uses), uses,
                       "a scrambled dimension of the Sobol' sequence, one after the other",
                       "nested scrambling keeps how many leading bits two points share");
  }
  const Columns got = columns_of("sobol", 64, fresh_seeds(rng, 24), {2, 2, 2, 2});
  for (unsigned d = 0; d < block_dims; ++d) {
    std::vector<View> columns;
    for (std::size_t set = 0; set < got.sets(); ++set) columns.push_back(got(set, d));
    expect_nested(got.call, columns, sobol_words(d, got.n), fmt::format("dimension {}", d));
  }
}

CHECK_CASE("6.3 the first dimensions of halton are Halton dimensions", "[6.3][points:4][needs:5]") {
  Rng rng = check_rng();
  for (const Uses& uses : ways) {
    expect_first_block(
        "halton", columns_of("halton", 61, {fresh_seed(rng)}, uses), uses,
        "radical inverses in one prime after the other, digits permuted",
        "two points share as many digits as their indices do: scrambling keeps that");
  }
  const Columns got = columns_of("halton", 64, fresh_seeds(rng, 24), {1});
  std::vector<View> columns;
  for (std::size_t set = 0; set < got.sets(); ++set) columns.push_back(got(set, 0));
  expect_nested(got.call, columns, sobol_words(0, got.n), "base 2");
}

CHECK_CASE("6.3 each seed and each dimension is randomised anew", "[6.3][points:3][needs:5]") {
  Rng rng = check_rng();
  // The first three dimensions, and three of the third block.
  Uses uses{1, 2};
  for (const unsigned use : repeated(7, {2})) uses.push_back(use);
  for (const unsigned use : {1u, 2u}) uses.push_back(use);
  for (const std::string kind : {"halton", "sobol"}) {
    const Columns got = columns_of(kind, 8, neighbours(fresh_seed(rng), 800), uses);
    for (const std::size_t c : {std::size_t{0}, std::size_t{1}, std::size_t{2}, got.dims - 3,
                                got.dims - 2, got.dims - 1}) {
      const Values x = got.first(c);
      const double largest_first = *std::max_element(x.begin(), x.end());
      expect_uniform(fmt::format("{}: coordinate {} of the first sample", got.call, c), x,
                     "the first sample is uniform over seeds",
                     largest_first == 0
                         ? "a sequence as it is has the origin for its first point: scramble it"
                         : same_for_seeds);
    }
    const std::string own = "one seed for several dimensions: each needs its own";
    for (const std::size_t c : {std::size_t{0}, std::size_t{1}, got.dims - 2}) {
      expect_uniform_pairs(
          fmt::format("{}: pairs of coordinates {} and {} of the first sample", got.call, c, c + 1),
          got.first(c), got.first(c + 1), "dimensions are randomised independently", own);
    }
  }
}

/// The blocks behind the first, by the coordinates that they are made of.
std::map<std::size_t, std::vector<std::size_t>> later_blocks(const Uses& uses) {
  std::map<std::size_t, std::vector<std::size_t>> blocks;
  const auto places = places_of(uses);
  for (std::size_t c = 0; c < places.size(); ++c) {
    if (places[c].block > 0) blocks[places[c].block].push_back(c);
  }
  return blocks;
}

/// Are these columns dimensions first, first + 1, … in the sequence's own order?
bool are_dimensions(const std::string& kind, const Block& columns, unsigned first) {
  for (unsigned d = 0; d < columns.size(); ++d) {
    if (!is_dimension(kind, columns[d], first + d)) return false;
  }
  return true;
}

/// Later blocks are dimensions 0 to 7 again, all of a block in one random order.
void expect_later_blocks(const std::string& kind, const Columns& got, const Uses& uses) {
  for (const auto& [number, coordinates] : later_blocks(uses)) {
    if (coordinates.size() < block_dims) continue;
    Block columns;
    for (const std::size_t c : coordinates) columns.push_back(got[c]);
    const bool in_own_order = are_dimensions(kind, columns, 0);
    const bool is_block =
        kind == "sobol" ? is_sobol_in_one_order(columns) : is_halton_in_one_order(columns);
    expect_that(
        is_block && !in_own_order,
        fmt::format("{}: coordinates {} to {} are {}", got.call, coordinates.front(),
                    coordinates.back(),
                    in_own_order ? "dimensions 0 to 7 in the order of the first block"
                                 : "not dimensions 0 to 7 of the same points"),
        fmt::format(
            "the first {} points of the sequence in eight dimensions, scrambled anew and in "
            "a random order",
            got.n),
        "a block is a point set in eight dimensions, independent of the other blocks",
        in_own_order ? "every block but the first needs a shuffle, one for all its dimensions"
        : number == 1 && are_dimensions(kind, columns, block_dims)
            ? "these are dimensions 8 to 15: after dimension 7 follows dimension 0, scrambled anew "
              "and in a random order"
            : "all dimensions of a block share one permutation; and where a next2() comes with one "
              "dimension left, that is left out: both of its axes are of the next block");
  }
}

/// Blocks are scrambled independently, and each has an order of its own.
void expect_independent_blocks(const std::string& kind, std::size_t n, Rng& rng) {
  const Uses uses = repeated(12, {2});
  const auto places = places_of(uses);
  const Columns got = columns_of(kind, n, {fresh_seed(rng)}, uses);
  Values index(n), all;
  std::iota(index.begin(), index.end(), 0.0);
  for (std::size_t c = 0; c < got.dims; ++c) {
    if (places[c].dimension == 0) all.insert(all.end(), got[c].begin(), got[c].end());
    if (places[c].block == 0) continue;
    expect_unrelated(got.call, index, got[c],
                     fmt::format("the numbers of the samples and coordinate {}", c),
                     "every block but the first needs a shuffle");
    for (std::size_t other = 0; other < c; ++other) {
      if (places[other].block == places[c].block) continue;
      expect_unrelated(got.call, got[other], got[c], fmt::format("coordinates {} and {}", other, c),
                       "each block needs a random permutation of its own");
    }
  }
  expect_all_different(got.call, all, "dimension 0 of three blocks",
                       "each block must be scrambled by seeds of its own");
}

CHECK_CASE("6.3 sobol begins anew after eight dimensions", "[6.3][points:4][needs:5]") {
  Rng rng = check_rng();
  for (const Uses& uses : {repeated(12, {2}), repeated(10, {1, 2}), repeated(24, {1})}) {
    expect_later_blocks("sobol", columns_of("sobol", 64, {fresh_seed(rng)}, uses), uses);
  }
  expect_independent_blocks("sobol", 1024, rng);
}

CHECK_CASE("6.3 halton begins anew after eight dimensions", "[6.3][points:3][needs:5]") {
  Rng rng = check_rng();
  for (const Uses& uses : {repeated(12, {2}), repeated(10, {1, 2}), repeated(24, {1})}) {
    expect_later_blocks("halton", columns_of("halton", 23, {fresh_seed(rng)}, uses), uses);
  }
  expect_independent_blocks("halton", 1009, rng);
}

}  // namespace
}  // namespace mc::checks
