// 5.9, over many seeds: that permutations are random, and what they cure; then columns, and
// refusals.

#include <array>
#include <numeric>

#include "5-halton/experiments.hpp"
#include "checks/halton/exact_inverses.hpp"
#include "checks/halton/one_in_each.hpp"
#include "checks/halton/randomness.hpp"
#include "checks/support/catch.hpp"
#include "checks/support/measure.hpp"

namespace mc::checks {
namespace {

/// How often each permutation of three digits came: 012, 021, 102, 120, 201, 210.
using Orders = std::array<std::uint64_t, 6>;

/// Which shuffle that is not one gives them, if one does.
std::string shuffle_hint(const Orders& orders, std::size_t count, const std::string& otherwise) {
  if (orders[0] + orders[3] + orders[4] == count && orders[0] > 0) {
    return "these are rotations: a random number was added to each digit, which gives 3 of the 6 "
           "permutations";
  }
  if (orders[3] + orders[4] == count) {
    return "no digit ever stays in place: one that is drawn for a place may be the one that is "
           "there already";
  }
  // Each of n digits swapped with any of n: 27 ways, of which three orders get 4 and three get 5.
  Orders sorted = orders;
  std::sort(sorted.begin(), sorted.end());
  bool naive = true;
  for (std::size_t i = 0; i < 6; ++i) {
    const double p = (i < 3 ? 4. : 5.) / 27, n = static_cast<double>(count);
    naive = naive && std::abs(static_cast<double>(sorted[i]) - n * p) < 5 * std::sqrt(n * p);
  }
  return naive ? "a biased shuffle: each digit was swapped with any, 27 ways for 6 permutations; "
                 "swap "
                 "digit i with one that is not yet in place (Fisher-Yates)"
               : otherwise;
}

CHECK_CASE("5.9 permutations are random for every position and seed", "[5.9][points:3]") {
  Rng rng = check_rng();
  // Power: of 20,000 orders of three digits, those of a naive shuffle (4/27 and 5/27 in place of
  // 1/6) have a chi-squared of 252 on average, with deviation 32; 47 are allowed.
  constexpr std::size_t count = 20000;
  constexpr unsigned base = 3;
  const auto measured = MEASURE(radical_inverses_scrambled, base, 0, 3, fresh_seeds(rng, count));
  const SetsOfPoints got(measured.exactly(3 * count, unit), 3, 1);
  const std::string& call = measured.call;
  std::vector<double> zero, behind, far_behind;
  std::vector<std::uint64_t> pairs(9);
  Orders orders{};
  for (std::size_t i = 0; i < count; ++i) {
    const auto three = got.column(i, 0);
    // They differ in their first digit only, so their order is that of their first digits.
    const auto rank = [&](std::size_t k) {
      return static_cast<std::size_t>(
          std::count_if(three.begin(), three.end(), [&](double x) { return x < three[k]; }));
    };
    expect_one_in_each(call, three);
    zero.push_back(three[0]);
    behind.push_back(wrapped(three[0] * base));
    far_behind.push_back(wrapped(three[0] * 3486784401.));  // 3^20
    ++orders[rank(0) * 2 + (rank(1) > rank(2) ? 1u : 0u)];
    ++pairs[rank(0) * base + static_cast<std::size_t>(behind.back() * base)];
  }
  const bool zeros_stay =
      std::all_of(behind.begin(), behind.end(), [](double value) { return value < 1e-9; });
  const bool pairs_alike = pairs[0] + pairs[4] + pairs[8] == count;
  const Hints hints{
      {},
      zeros_stay    ? "the zeros behind the last digit are digits too: permute them, to 2^-53"
      : pairs_alike ? "one permutation for all positions: each has its own"
                    : "a random permutation for each position, from a hash of seed and position"};
  const double sixth = 1. / 6, ninth = 1. / 9;
  expect_counts(call + ", how often each permutation of the three digits came", orders,
                std::span(&sixth, 1), {"all six permutations are equally likely", one_alpha},
                {{}, shuffle_hint(orders, count, hints.otherwise)});
  expect_counts(call + ", the first digit of index 0 with its second", pairs, std::span(&ninth, 1),
                {"the permutations of two positions are independent", one_alpha}, hints);
  expect_distribution(call + ", of index 0", zero, uniform_cdf,
                      {"the scrambled value of index 0 is uniform", one_alpha}, hints);
  expect_distribution(call + ", of index 0 behind its first digit", behind, uniform_cdf,
                      {"the digits behind the last one are permuted", one_alpha}, hints);
  expect_distribution(call + ", of index 0 behind its 20th digit", far_behind, uniform_cdf,
                      {"the digits far behind the last one are permuted", one_alpha}, hints);
  // Neighbouring seeds, as axes and pixels have them.
  constexpr std::size_t pairs_of_seeds = 12800;
  std::vector<std::uint64_t> row(2 * pairs_of_seeds);
  std::iota(row.begin(), row.end(), rng() >> 1);
  const auto neighbours = MEASURE(radical_inverses_scrambled, 5, 7, 1, row);
  expect_even_pairs(neighbours.call + ", by a seed and by the next",
                    neighbours.exactly(row.size(), unit),
                    {"neighbouring seeds give independent permutations", one_alpha},
                    {{},
                     "seeds that differ a little give permutations that are not independent: "
                     "seed + position is the same for a seed and the next position, and for the "
                     "next seed and this position"});
}

CHECK_CASE("5.9 permuted digits cure the bad pair 29 and 31", "[5.9][points:3]") {
  Rng rng = check_rng();
  constexpr std::size_t n = 64, count = 400;
  const auto along_x = MEASURE(radical_inverses_scrambled, 29, 0, n, fresh_seeds(rng, count));
  const auto along_y = MEASURE(radical_inverses_scrambled, 31, 0, n, fresh_seeds(rng, count));
  const SetsOfPoints xs(along_x.exactly(n * count, unit), n, 1);
  const SetsOfPoints ys(along_y.exactly(n * count, unit), n, 1);
  double empty = 0;
  for (std::size_t set = 0; set < count; ++set) {
    const auto x = xs.column(set, 0), y = ys.column(set, 0);
    expect_one_in_each(along_x.call, x.subspan(29, 29));
    expect_one_in_each(along_y.call, y.subspan(31, 31));
    std::vector<bool> taken(64);
    for (std::size_t i = 0; i < n; ++i) {
      taken[static_cast<std::size_t>(x[i] * 8) * 8 + static_cast<std::size_t>(y[i] * 8)] = true;
    }
    empty += static_cast<double>(std::count(taken.begin(), taken.end(), false)) / count;
  }
  // 64 independent points leave 64 (63/64)^64 = 23.4 of 64 cells empty on average, these 20;
  // unpermuted, 47. With numbers of empty cells between 0 and 63, a mean of 400 lies 12 above its
  // expectation less than once in 10^12 runs (Hoeffding).
  expect_that(empty <= 33,
              fmt::format("{} and base 31: of 8 x 8 cells, 64 points leave {:.1f} empty",
                          along_x.call, empty),
              "about 20, and 33 at most",
              "64 points in the plane of bases 29 and 31 lie on a few lines, and leave 47 cells "
              "empty; randomly permuted digits do not",
              "a shift or a flip of bits moves the lines; permuting the digits breaks them");
}

CHECK_CASE("5.9 a scrambled column depends on index and seed alone", "[5.9][points:2][edge]") {
  Rng rng = check_rng();
  for (const unsigned base : {3u, 2u, 29u, 7919u, 65536u}) {
    const std::uint64_t seed = rng(), first = rng() >> (rng() % 40 + 1);
    const std::uint64_t count = 500 + rng() % 2000, skip = rng() % 400;
    const auto whole = MEASURE(radical_inverses_scrambled, base, first, count, {seed});
    const auto later = MEASURE(radical_inverses_scrambled, base, first + skip, 50, {seed});
    const auto &all = whole.exactly(count, unit), &some = later.exactly(50, unit);
    for (std::size_t i = 0; i < 50; ++i) {
      expect_within(fmt::format("{}, value {}", later.call, i), some[i], all[skip + i],
                    2 * inverse_tolerance,
                    fmt::format("the same index as value {} of {}; each is within 4 * 2^-53",
                                skip + i, whole.call),
                    {{}, "where a column begins must not matter"});
    }
  }
  // The last index of all is the last value; and no column is too short.
  const std::uint64_t seed = rng();
  const auto last = MEASURE(radical_inverses_scrambled, 2, last_index - 599, 600, {seed});
  const auto one = MEASURE(radical_inverses_scrambled, 2, last_index, 1, {seed});
  expect_within(one.call, one.exactly(1, unit)[0], last.exactly(600, unit)[599],
                2 * inverse_tolerance, "the same index; each is within 4 * 2^-53",
                {{}, "where a column begins must not matter"});
  MEASURE(radical_inverses_scrambled, 2, 7, 0, {seed}).exactly(0);
}

CHECK_CASE("5.9 bases and indices that do not exist are refused", "[5.9][points:1][edge]") {
  for (const unsigned base : {0u, 1u, 65537u}) {
    expect_refused(MEASURE_OUTCOME(radical_inverses_scrambled, base, 0, 10, {1}),
                   "bases from 2 to 2^16");
  }
  expect_refused(MEASURE_OUTCOME(radical_inverses_scrambled, 3, last_index - 1, 3, {1}),
                 "the last index is 2^64 - 1, and the third one would be 2^64");
}

}  // namespace
}  // namespace mc::checks
