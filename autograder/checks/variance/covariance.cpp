// 1.6: the covariance.

#include <cmath>

#include <fmt/format.h>

#include "1-variance/experiments.hpp"
#include "checks/support/catch.hpp"
#include "expect_variance.hpp"

namespace mc::checks {
namespace {

/// Values of two variables of which y goes against x, neither of them nearly constant: kappa is
/// below 4 for both.
struct Pairs {
  Values x, y;
};
Pairs tame_pairs(Rng& rng, std::size_t n) {
  Pairs pairs{tame_values(rng, n, -1, 1), uniform_values(rng, n, -0.5, 0.5)};
  for (std::size_t i = 0; i < n; ++i) pairs.y[i] -= 2 * pairs.x[i];
  return pairs;
}

/// What a covariance is judged by.
struct ExactPairs {
  ExactPairs(const Pairs& pairs)
      : n(static_cast<double>(pairs.x.size())),
        covariance(static_cast<double>(exact_codeviation(pairs.x, pairs.y)) / (n - 1)) {
    const auto of_x = exact_moments(pairs.x), of_y = exact_moments(pairs.y);
    sigmas = std::sqrt(of_x.variance) * std::sqrt(of_y.variance);
    kappa_x = condition(of_x);
    kappa_y = condition(of_y);
    means = static_cast<double>(of_x.mean * of_y.mean);
  }
  double n, covariance;
  double sigmas = 0;  ///< sigma of x times sigma of y: the scale of the problem
  double kappa_x = 0, kappa_y = 0;
  double means = 0;  ///< the product of the two
};

Hints covariance_hints(double got, const ExactPairs& exact, const std::string& otherwise) {
  const double n = exact.n, covariance = exact.covariance;
  const double mean_product = covariance * (n - 1) / n + exact.means;
  return {nearest(got, covariance,
                  {{covariance * (n - 1) / n,
                    "this divides by n; a sample covariance divides by n - 1 (and n/(n-1) of whole "
                    "numbers is 1)"},
                   {covariance * n / (n - 1), "n/(n-1) is in here twice: once is enough"},
                   {covariance * (n - 1), "this is the sum of products, not divided yet"},
                   {-covariance, "the sign is wrong: both deviations are value - mean"},
                   {mean_product, "this is E{XY}: take E{X}E{Y} off"},
                   {mean_product * n / (n - 1), "this is E{XY} n/(n-1): the means are not in it"},
                   {covariance / exact.sigmas,
                    "this is the correlation: do not divide by the deviations"}}),
          otherwise};
}

CHECK_CASE("1.6 the covariance of pairs", "[1.6][main][points:3]") {
  Rng rng = check_rng();
  for (const std::size_t n : {10u, 1000u, 3u, 2u}) {
    const Pairs pairs = tame_pairs(rng, n);
    const ExactPairs exact(pairs);
    const auto got = MEASURE(covariance, pairs.x, pairs.y);
    expect_within(
        got.call, got.value, exact.covariance,
        10 * exact.n * eps * exact.kappa_x * exact.kappa_y * exact.sigmas,
        "n additions lose at most n eps of the sum of products; one digit less is enough",
        covariance_hints(got.value, exact, "sum (x - mean x)(y - mean y) and divide by n - 1"));
  }
}

/// What the header promises: in one pass or two, any way that knows the means.
void expect_promised(const Pairs& pairs, const std::string& otherwise) {
  const ExactPairs exact(pairs);
  const auto got = MEASURE(covariance, pairs.x, pairs.y);
  expect_within(got.call, got.value, exact.covariance,
                10 * exact.n * eps * (exact.kappa_x + exact.kappa_y) * exact.sigmas,
                "two running means lose at most n eps (kappa x + kappa y) sigma x sigma y, kappa = "
                "sqrt(1 + mean^2 / variance); one digit less is enough",
                covariance_hints(got.value, exact, otherwise));
}

CHECK_CASE("1.6 the covariance keeps its digits under large means", "[1.6][points:3]") {
  Rng rng = check_rng();
  for (const double offset : {1e9, 1e6, 1e12}) {
    Pairs pairs{shifted_pattern(rng, offset, 1000), shifted_pattern(rng, offset, 1000)};
    for (std::size_t i = 0; i < 1000; ++i) pairs.y[i] += 2 * (pairs.x[i] - offset);
    expect_promised(pairs,
                    "E{XY} - E{X}E{Y} is the textbook formula again: subtract the means first");
  }
}

CHECK_CASE("1.6 the covariance keeps its digits at any scale", "[1.6][points:1]") {
  Rng rng = check_rng();
  const std::pair<double, double> scales[] = {{1e-4, 1e4}, {1e4, 1e-4},     {1e-4, 1e-4},
                                              {1e-9, 1e9}, {1e-150, 1e150}, {1e-100, 1e-100}};
  for (const auto& [of_x, of_y] : scales) {
    Pairs pairs = tame_pairs(rng, 100);
    for (double& x : pairs.x) x *= of_x;
    for (double& y : pairs.y) y *= of_y;
    expect_promised(pairs,
                    "small is not zero: use no threshold. Is it taken from Var{X + Y}? There the "
                    "rounding of the larger variance is larger than the covariance");
  }
}

CHECK_CASE("1.6 there is no covariance of one pair or of NaN", "[1.6][edge][points:1]") {
  Rng rng = check_rng();
  for (const Values& x : {Values{uniform(rng, 1, 2)}, Values{}}) {
    const auto got = MEASURE(covariance, x, x);
    expect_nan(got.call, got.value, "a sample covariance needs two pairs; " + because_undefined);
  }
  for (const Values& x : without_finite_variance(rng)) {
    const Values y = uniform_values(rng, x.size(), 1, 2);
    if (x.size() < 100) continue;  // finite values: their products with these may be, too
    const auto got = MEASURE(covariance, x, y), turned = MEASURE(covariance, y, x);
    expect_no_number(got.call, got.value, x);
    expect_no_number(turned.call, turned.value, x);
  }
}

const std::string because_no_pairs = "there are no pairs where the sizes differ";

CHECK_CASE("1.6 lists of two sizes are refused", "[1.6][edge][points:1]") {
  expect_refused(MEASURE_OUTCOME(covariance, {1, 2, 3}, {1, 2}), because_no_pairs);
  expect_refused(MEASURE_OUTCOME(covariance, {1, 2}, {1, 2, 3}), because_no_pairs);
  expect_refused(MEASURE_OUTCOME(covariance, {1}, {}), because_no_pairs);
}

CHECK_CASE("1.6 the refusal names the argument", "[1.6][edge][points:1]") {
  expect_invalid_argument(MEASURE_OUTCOME(covariance, {1, 2, 3}, {1, 2}), "x|y", because_no_pairs);
}

}  // namespace
}  // namespace mc::checks
