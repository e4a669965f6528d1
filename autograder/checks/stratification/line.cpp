// 3.1: strata on the line. Where points must lie is exact: strata are counted, with the edges that
// double division gives. How they lie there is random (jitter.hpp), and all sets are fresh in each
// run. Nothing depends on the order in which a submission draws.

#include <array>
#include <cmath>
#include <numbers>

#include "checks/stratification/levels.hpp"
#include "checks/support/catch.hpp"

namespace mc::checks {
namespace {

constexpr std::uint64_t all_ones = ~std::uint64_t{0};

Sets lines(Rng& rng, std::size_t n, std::size_t sets) {
  return columns_of(MEASURE(stratified_1d, n, sets, fresh_seed(rng)), n, 1, sets, n);
}

TEST_CASE("3.1 one point in each stratum and in order", "[3.1][main][points:3]") {
  Rng rng = check_rng();
  for (const std::size_t n : {64u, 10u, 1000u, 1009u, 7u, 3u, 2u, 1u}) {
    const Sets got = lines(rng, n, 3);
    for (std::size_t set = 0; set < 3; ++set) expect_in_order(got.call, got.column(set, 0));
    if (n == 64) expect_drawn_afresh(got, lines(rng, n, 1), std::array{n});
  }
}

TEST_CASE("3.1 each point is uniform in its stratum", "[3.1][points:4]") {
  Rng rng = check_rng();
  const Sets many = lines(rng, 16, 4000);
  expect_uniform_jitter(many.call, jitters_of(many, 0, 16), 16,
                        "the points of 3.1 are uniform in their strata");
  const Sets one = lines(rng, 1, 8000);
  const double each = 1.0 / 32;
  expect_counts(one.call + ", points in 32 equal parts of [0, 1)",
                counts_of(jitters_of(one, 0, 1), 32), std::span(&each, 1),
                {"one stratum is all of [0,1)", alpha}, {{}, "one point is uniform in [0, 1)"});
}

TEST_CASE("3.1 the strata are independent of each other", "[3.1][points:3]") {
  Rng rng = check_rng();
  constexpr std::size_t n = 16, sets = 1000;
  const std::uint64_t seed = fresh_seed(rng);
  const Sets got = columns_of(MEASURE(stratified_1d, n, sets, seed), n, 1, sets, n);
  const Values u = jitters_of(got, 0, n);
  Values even, odd, low, high, before, after;
  for (std::size_t k = 0; k < u.size(); ++k) {
    const std::size_t set = k / n, i = k % n;
    (i % 2 == 0 ? even : odd).push_back(u[k]);
    (set % 2 == 0 ? before : after).push_back(u[k]);
    if (i < n / 2) low.push_back(u[k]), high.push_back(u[set * n + n - 1 - i]);
  }
  expect_independent(got.call, even, odd, "neighbouring strata of 3.1 are independent",
                     one_for_all);
  expect_independent(got.call, low, high, "strata i and N-1-i of 3.1 are independent", one_for_all);
  expect_independent(got.call, before, after, "one set of 3.1 is independent of the next",
                     "the same numbers in every set: draw them from the generator you are given");
  const Sets next = columns_of(MEASURE(stratified_1d, n, sets, seed + 1), n, 1, sets, n);
  expect_independent(got.call + " and the next seed", u, jitters_of(next, 0, n),
                     "neighbouring seeds give independent points in 3.1",
                     "the same numbers for every seed: draw them from the generator you are given");
}

TEST_CASE("3.1 the error falls as N^-1.5", "[3.1][points:2]") {
  Rng rng = check_rng();
  const std::string otherwise =
      "the variance within the strata is all that may be left: is each point uniform in its "
      "stratum, and independent of the others?";
  const auto expected = [](std::size_t n) { return expected_of(strata_of(exponential, n)); };
  const Tested g = sum_over_axes("exp(x)", exponential);
  expect_level(lines(rng, 64, 1000), g, expected(64),
               "estimates of exp(x) over 64 strata have their exact variance", otherwise);
  expect_slope(lines(rng, 16, 500), lines(rng, 256, 500), g, {expected(16), expected(256)},
               "errors for exp(x) fall as N^-1.5", otherwise);
}

TEST_CASE("3.1 a wave in each stratum gains nothing", "[3.1][points:1]") {
  Rng rng = check_rng();
  constexpr std::size_t n = 64;
  const Tested wave{"cos(2 pi N x)", [](View x) {
                      return std::cos(2 * std::numbers::pi * static_cast<double>(n) * x[0]);
                    }};
  // Every stratum has a whole period: mean 0, variance 1/2, kurtosis 3/2, as the whole line.
  expect_level(
      lines(rng, n, 1000), wave, {0, 0.5 / n, 3 - 1.5 / n},
      "all variance of a wave with N periods is within the strata: as for independent points",
      "is each point uniform in its stratum, and independent of the others?");
}

TEST_CASE("3.1 no point leaves its stratum whatever the bits", "[3.1][edge][points:2]") {
  Rng rng = check_rng();
  for (const std::size_t n :
       {std::size_t{1000}, std::size_t{49}, 2 + rng() % 5000, std::size_t{1009},
        std::size_t{999983}, std::size_t{5}, std::size_t{3}, std::size_t{2}, std::size_t{1}}) {
    for (const std::uint64_t word : {all_ones, std::uint64_t{0}, rng()}) {
      const auto got = MEASURE(stratified_1d_constant, n, word);
      expect_in_order(got.call, columns_of(got, n, 1, 1, n).column(0, 0));
    }
  }
}

}  // namespace
}  // namespace mc::checks
