// 6.3: dimensions of the Halton and the Sobol' sequence, in blocks of eight.

#include "checks/sampler/sequences.hpp"

#include <map>
#include <numeric>

#include "checks/sampler/relations.hpp"
#include "checks/sampler/samplers.hpp"
#include "checks/support/catch.hpp"

namespace mc::checks {
namespace {

/// Is the column this dimension of the sequence, in the sequence's own order?
bool is_dimension(const std::string& kind, View x, unsigned d) {
  if (kind == "sobol") return is_scrambled_sobol(x, d);
  return is_scrambled_halton(x, first_primes[d]);
}

/// Which dimension of the sequence a block has at this place.
unsigned in_block(const std::string& kind, std::size_t place) {
  return kind == "sobol" ? sobol_block[place] : static_cast<unsigned>(place);
}

/// Each coordinate of the first block is the dimension that its place asks for.
void check_first_block(const std::string& kind, const Columns& got, const Uses& uses,
                       const std::string& what, const std::string& because) {
  const auto places = places_of(uses);
  for (std::size_t c = 0; c < got.dims; ++c) {
    if (places[c].block > 0) continue;
    const unsigned d = in_block(kind, places[c].dimension);
    if (is_dimension(kind, got[c], d)) continue;
    std::string hint = "is it the sequence from index 0, in its own order, one point per sample?";
    for (unsigned other = 0; other < (kind == "sobol" ? 32u : 10u); ++other) {
      if (!is_dimension(kind, got[c], other)) continue;  // in larger primes few digits come twice
      hint = fmt::format(
          "this is dimension {}: a next2() takes the next pair of the block when it is first asked "
          "for, a next() the first half of the next pair, and the next() after it the other half",
          other);
      break;
    }
    expect_that(false, fmt::format("{}: coordinate {} is not dimension {}", got.call, c, d), what,
                because, hint);
  }
  pass();
}

/// Uses whose first eight dimensions are asked for in several ways.
const std::vector<Uses> ways{{1, 2, 1, 2, 2}, {2, 2, 2, 2}, {1, 1, 1, 1, 1, 1, 1, 1},
                             {1, 2, 2, 2},    {2, 1, 2, 2}, {2, 1, 1, 1, 2}};

/// Not a digital shift, in one of these columns at least. In one column of 64 nested flips agree by
/// chance with probability 2^-57, and with a hash of few random bits still not more than once in 8.
void check_nested(const std::string& call, const std::vector<View>& columns,
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
    check_first_block("sobol", columns_of("sobol", 61, {fresh_seed(rng)}, uses), uses,
                      "a scrambled dimension of the Sobol' sequence: pairs (0, 1), (4, 6), "
                      "(16, 20), (15, 21)",
                      "nested scrambling keeps how many leading bits two points share");
  }
  const Columns got = columns_of("sobol", 64, fresh_seeds(rng, 24), {2, 2, 2, 2});
  for (unsigned d = 0; d < block_dims; ++d) {
    std::vector<View> columns;
    for (std::size_t set = 0; set < got.sets(); ++set) columns.push_back(got(set, d));
    check_nested(got.call, columns, sobol_words(sobol_block[d], got.n),
                 fmt::format("dimension {}", sobol_block[d]));
  }
}

CHECK_CASE("6.3 the first dimensions of halton are Halton dimensions", "[6.3][points:4][needs:5]") {
  Rng rng = check_rng();
  for (const Uses& uses : ways) {
    check_first_block("halton", columns_of("halton", 61, {fresh_seed(rng)}, uses), uses,
                      "radical inverses in one prime after the other, digits permuted",
                      "two points share as many digits as their indices do: scrambling keeps that");
  }
  const Columns got = columns_of("halton", 64, fresh_seeds(rng, 24), {1});
  std::vector<View> columns;
  for (std::size_t set = 0; set < got.sets(); ++set) columns.push_back(got(set, 0));
  check_nested(got.call, columns, sobol_words(0, got.n), "base 2");
}

CHECK_CASE("6.3 each seed and each dimension is randomised anew", "[6.3][points:3][needs:5]") {
  Rng rng = check_rng();
  // The first three dimensions, and three of the third block.
  Uses uses{1, 2};
  for (const unsigned use : repeated(7, {2})) uses.push_back(use);
  for (const unsigned use : {1u, 2u}) uses.push_back(use);
  for (const std::string kind : {"halton", "sobol"}) {
    const Columns got = columns_of(kind, 8, fresh_seeds(rng, 1000), uses);
    const Uniforms firsts = got.first_samples();
    bool is_plain = true;
    for (std::size_t set = 0; set < got.sets(); ++set) is_plain = is_plain && got(set, 0)[0] == 0;
    auto failure = dependence_in(
        firsts, {.words = "each dimension of each block is randomized by a seed of its own",
                 .alpha = alpha,
                 .otherwise = same_for_seeds,
                 .same = "one seed for several dimensions: each needs its own"});
    if (failure && is_plain) {
      failure->likely = "a sequence as it is has the origin for its first point: scramble it";
    }
    if (failure) fail(*failure);
  }
  pass();
}

/// The blocks after the first that are complete: their coordinates, in the order of the block.
std::map<std::size_t, std::vector<std::size_t>> later_blocks(const Uses& uses) {
  std::map<std::size_t, std::vector<std::size_t>> blocks;
  const auto places = places_of(uses);
  for (std::size_t place = 0; place < block_dims; ++place) {
    for (std::size_t c = 0; c < places.size(); ++c) {
      if (places[c].block > 0 && places[c].dimension == place) {
        blocks[places[c].block].push_back(c);
      }
    }
  }
  std::erase_if(blocks, [](const auto& block) { return block.second.size() < block_dims; });
  return blocks;
}

Block columns_of_block(const Columns& got, const std::vector<std::size_t>& coordinates) {
  Block columns;
  for (const std::size_t c : coordinates) columns.push_back(got[c]);
  return columns;
}

/// Are these columns the dimensions of a block, or those from `first` on, in the sequence's order?
bool are_dimensions(const std::string& kind, const Block& columns, std::optional<unsigned> first) {
  for (std::size_t k = 0; k < columns.size(); ++k) {
    const unsigned d = first ? *first + static_cast<unsigned>(k) : in_block(kind, k);
    if (!is_dimension(kind, columns[k], d)) return false;
  }
  return true;
}

/// Where samples first … first + 2^k - 1, `first` a multiple of 2^k, have not 2^k points in a row:
/// in words. In base b each value of the first digit comes 2^k / b times, rounded up or down; in
/// base 2 all values of the first k digits come once.
std::string unevenness(const std::string& kind, const Block& columns) {
  const std::size_t n = columns[0].size();
  for (std::size_t size = 2; size <= n; size *= 2) {
    for (std::size_t first = 0; first + size <= n; first += size) {
      for (std::size_t d = 0; d < columns.size(); ++d) {
        const bool is_binary = kind == "sobol" || d == 0;
        const std::size_t parts = is_binary ? size : first_primes[d];
        std::vector<std::size_t> counts(parts);
        for (const double x : columns[d].subspan(first, size)) {
          const double part = x * static_cast<double>(parts) + 0x1p-45;
          ++counts[std::min(static_cast<std::size_t>(part), parts - 1)];
        }
        for (const std::size_t count : counts) {
          if (count == size / parts || count == (size + parts - 1) / parts) continue;
          return fmt::format(
              "samples {} to {} have {} numbers in one of {} parts of [0, 1), in its "
              "dimension {}",
              first, first + size - 1, count, parts, in_block(kind, d));
        }
      }
    }
  }
  return "";
}

/// Later blocks are the same dimensions again, all of a block in one order.
void check_later_blocks(const std::string& kind, const Columns& got, const Uses& uses) {
  for (const auto& [number, coordinates] : later_blocks(uses)) {
    const Block columns = columns_of_block(got, coordinates);
    const bool in_own_order = are_dimensions(kind, columns, {});
    const bool is_block =
        kind == "sobol" ? is_sobol_in_one_order(columns) : is_halton_in_one_order(columns);
    const std::string block =
        fmt::format("{}: the block of coordinates {} to {}", got.call,
                    *std::min_element(coordinates.begin(), coordinates.end()),
                    *std::max_element(coordinates.begin(), coordinates.end()));
    expect_that(
        is_block && !in_own_order,
        block + (in_own_order ? " has the points in the order of the first block"
                              : " does not have its eight dimensions of the same points"),
        fmt::format(
            "the first {} points of the sequence in eight dimensions, scrambled anew and in "
            "an order of their own",
            got.n),
        "a block is a point set in eight dimensions, independent of the other blocks",
        in_own_order ? "every block but the first needs a shuffle, one for all its dimensions"
        : number == 1 && (are_dimensions(kind, columns, 8) || are_dimensions("halton", columns, 8))
            ? "these are dimensions 8 to 15: after its eight dimensions a block comes again, "
              "scrambled anew and in another order"
            : "all dimensions of a block share one order; and where a next2() comes after the last "
              "pair, both of its axes are of the next block");
  }
}

/// And may be stopped early: of any number of samples.
void check_prefixes(const std::string& kind, const Columns& got, const Uses& uses) {
  for (const auto& [number, coordinates] : later_blocks(uses)) {
    const std::string uneven = unevenness(kind, columns_of_block(got, coordinates));
    expect_that(uneven.empty(), fmt::format("{}, block {}: {}", got.call, number, uneven),
                "2^k points in a row for samples j 2^k to (j + 1) 2^k - 1",
                "a block may be stopped early: a nested shuffle keeps these points together",
                "a uniform shuffle spreads the first points of a block over all samples: scramble "
                "the numbers of the samples as 5.8 does, from the highest bit on");
  }
}

/// Two columns in nested orders: their sum of products has 1.6 times the variance that it has in
/// uniform permutations (measured), since both change halves from sample 2j to 2j + 1.
constexpr double nested_variance = 2;

/// Blocks are scrambled independently, and each has an order of its own.
void check_independent_blocks(const std::string& kind, std::size_t n, Rng& rng) {
  const Uses uses = repeated(12, {2});
  const auto places = places_of(uses);
  const Columns got = columns_of(kind, n, {fresh_seed(rng)}, uses);
  Values index(n), all;
  std::iota(index.begin(), index.end(), 0.0);
  for (std::size_t c = 0; c < got.dims; ++c) {
    if (places[c].dimension == 0) all.insert(all.end(), got[c].begin(), got[c].end());
    if (places[c].block == 0) continue;
    check_unrelated(got.call, index, got[c],
                    fmt::format("the numbers of the samples and coordinate {}", c),
                    "every block but the first needs a shuffle", nested_variance);
    for (std::size_t other = 0; other < c; ++other) {
      if (places[other].block == places[c].block) continue;
      check_unrelated(got.call, got[other], got[c], fmt::format("coordinates {} and {}", other, c),
                      "each block needs a random permutation of its own", nested_variance);
    }
  }
  check_all_different(got.call, all, "dimension 0 of three blocks",
                      "each block must be scrambled by seeds of its own");
}

const std::vector<Uses> long_ways{repeated(12, {2}), repeated(10, {1, 2}), repeated(24, {1})};

CHECK_CASE("6.3 sobol begins anew after eight dimensions", "[6.3][points:3][needs:5]") {
  Rng rng = check_rng();
  for (const Uses& uses : long_ways) {
    check_later_blocks("sobol", columns_of("sobol", 64, {fresh_seed(rng)}, uses), uses);
  }
  check_independent_blocks("sobol", 1024, rng);
}

CHECK_CASE("6.3 halton begins anew after eight dimensions", "[6.3][points:3][needs:5]") {
  Rng rng = check_rng();
  for (const Uses& uses : long_ways) {
    check_later_blocks("halton", columns_of("halton", 16, {fresh_seed(rng)}, uses), uses);
  }
  check_independent_blocks("halton", 1000, rng);
}

CHECK_CASE("6.3 later blocks may be stopped early", "[6.3][points:2][needs:5]") {
  Rng rng = check_rng();
  for (const std::string kind : {"sobol", "halton"}) {
    for (const std::size_t n : {64u, 1024u, 1000u, 100u, 33u, 7u}) {
      const Uses& uses = long_ways[n % long_ways.size()];
      check_prefixes(kind, columns_of(kind, n, {fresh_seed(rng)}, uses), uses);
    }
  }
}

}  // namespace
}  // namespace mc::checks
