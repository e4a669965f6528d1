// 3.1: strata on the line. Where points must lie is exact: strata are counted, with the edges that
// double division gives. How they lie there is random (jitter.hpp), and all sets are fresh in each
// run. Nothing depends on the order in which a submission draws.

#include <array>
#include <cmath>
#include <numbers>

#include "checks/stratification/levels.hpp"
#include "checks/support/catch.hpp"
#include "checks/support/sample_sets.hpp"

namespace mc::checks {
namespace {

constexpr std::uint64_t all_ones = ~std::uint64_t{0};

Sets lines(Rng& rng, std::size_t n, std::size_t sets) {
  return columns_of(MEASURE(stratified_1d, n, sets, fresh_seed(rng)), n, 1, sets, n);
}

CHECK_CASE("3.1 one point in each stratum and in order", "[3.1][main][points:3]") {
  Rng rng = check_rng();
  for (const std::size_t n : {64u, 10u, 1000u, 1009u, 7u, 3u, 2u, 1u}) {
    const Sets got = lines(rng, n, 3);
    for (std::size_t set = 0; set < 3; ++set) expect_in_order(got.call, got.column(set, 0));
    if (n == 64) expect_drawn_afresh(got, lines(rng, n, 1), std::array{n});
  }
}

/// The jitters of sets of n strata, made by one call with this seed.
Uniforms jitters_on_a_line(std::size_t n, std::size_t sets, std::uint64_t seed) {
  const SampleSets lines = sets_from_columns(MEASURE(stratified_1d, n, sets, seed), n, 1, sets, n);
  return jitters_of(lines, std::array{n}, [](std::size_t, std::size_t k) { return k; });
}

CHECK_CASE("3.1 each point is uniform in its stratum", "[3.1][points:4]") {
  Rng rng = check_rng();
  for (const std::size_t n : {16u, 1u, 37u, 100u}) {
    expect_independent_uniforms(
        jitters_on_a_line(n, std::max<std::size_t>(400, 20000 / n), fresh_seed(rng)),
        {.words = fmt::format("the points of {} strata are uniform in them", n),
         .alpha = alpha,
         .otherwise = "each point is (i + u) / n with a u of its own, uniform in [0, 1)",
         .repeated = come_again,
         .same = one_for_all},
        true);
  }
}

CHECK_CASE("3.1 the strata are independent of each other", "[3.1][points:3]") {
  Rng rng = check_rng();
  const Randomness claim{.words = "the strata of 3.1 are independent of each other",
                         .alpha = alpha,
                         .otherwise = "draw a random number for each stratum, from the generator",
                         .repeated = come_again,
                         .same = one_for_all};
  const std::uint64_t seed = fresh_seed(rng);
  Uniforms sets = jitters_on_a_line(37, 1000, seed);
  expect_independent_uniforms(sets, claim);
  expect_independent_uniforms(side_by_side(sets, jitters_on_a_line(37, 1000, seed + 1)), claim);
}

CHECK_CASE("3.1 the error falls as N^-1.5", "[3.1][points:2]") {
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

CHECK_CASE("3.1 a wave in each stratum gains nothing", "[3.1][points:1]") {
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

CHECK_CASE("3.1 no point leaves its stratum whatever the bits", "[3.1][edge][points:2]") {
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
