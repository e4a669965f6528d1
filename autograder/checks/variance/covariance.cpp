// 1.6: the covariance.

#include "1-variance/experiments.hpp"
#include "data_sets.hpp"
#include "list_results.hpp"

namespace mc::checks {
namespace {

struct Pairs {
  Values x, y;
};

Pairs tame_pairs(Rng& rng, std::size_t n, double of_x = 1, double of_y = 1);
Pairs far_pairs(Rng& rng, double offset, std::size_t n);
void judge_pairs(const std::vector<Pairs>& all, const std::string& rule);

CHECK_CASE("1.6 the covariance of pairs", "[1.6][main][points:4]") {
  std::vector<Pairs> pairs;
  for (const List& list : tame_lists(rng, 2, -1, 1))
    pairs.push_back(tame_pairs(rng, list.x.size()));
  pairs.push_back({pairs[0].x, pairs[0].x});  // the variance
  judge_pairs(pairs,
              "sum (x - mean x)(y - mean y) and divide by n - 1; if the means are updated value by "
              "value, one of the two deviations is from the mean before the update");
}

CHECK_CASE("1.6 the covariance keeps its digits under large means", "[1.6][points:3][needs:1.1]") {
  std::vector<Pairs> pairs;
  for (const double offset : {1e9, 1e6, -1e12}) {
    for (const std::size_t n : {1000u, 7u}) pairs.push_back(far_pairs(rng, offset, n));
  }
  pairs.push_back({pairs[0].x, tame_pairs(rng, 1000).y});
  pairs.push_back({tame_pairs(rng, 1000).y, pairs[0].x});
  pairs.push_back({Values(1000, 0.1), tame_pairs(rng, 1000).y});  // covariance 0
  judge_pairs(pairs,
              "E{XY} - E{X}E{Y} is the textbook formula again: subtract the means of both first");
}

CHECK_CASE("1.6 the covariance keeps its digits at any scale", "[1.6][points:2][needs:1.1]") {
  std::vector<Pairs> pairs;
  constexpr std::pair<double, double> scales[] = {{1e-4, 1e4},    {1e4, 1e-4},     {1e-4, 1e-4},
                                                  {1e-9, 1e9},    {1e-150, 1e150}, {1e-100, 1e-100},
                                                  {-1e100, 1e-3}, {1e-200, 1e200}, {1e200, 1e-250},
                                                  {0, 1},         {1, 0}};
  for (const auto& [of_x, of_y] : scales) pairs.push_back(tame_pairs(rng, 100, of_x, of_y));
  constexpr double d = 0x1p-43;  // a covariance of 4/3 d: small compared with sigma x sigma y
  pairs.push_back({{1, -1, 1, -1}, {1 + d, 1 - d, -1 + d, -1 - d}});
  judge_pairs(pairs,
              "a covariance scales as x y: no term may scale as x^2 or y^2, as in Var{X + Y} or in "
              "a correction with the wrong sum; and use no threshold: small is not zero");
}

CHECK_CASE("1.6 the covariance of one pair or of NaN is not finite", "[1.6][edge][points:1]") {
  for (const Values& x : {Values{uniform(rng, 1, 2)}, Values{}}) {
    const auto got = MEASURE(covariance, x, x);
    expect_nan(got.call, got.value, "a sample covariance needs two pairs; " + because_undefined);
  }
  for (const Values& x : with_a_value_that_is_not_finite(rng)) {
    for (const Values& y : {uniform_values(rng, x.size(), 1, 2), Values(x.size(), 1)}) {
      const auto got = MEASURE(covariance, x, y), turned = MEASURE(covariance, y, x);
      expect_not_finite(got.call, got.value, x);
      expect_not_finite(turned.call, turned.value, x);
    }
  }
}

// What the cases above use ------------------------------------------------------------------------

/// Two negatively correlated variables, neither nearly constant: kappa is below 4 for both.
Pairs tame_pairs(Rng& rng, std::size_t n, double of_x, double of_y) {
  Pairs pairs{tame_values(rng, n, -1, 1), uniform_values(rng, n, -0.5, 0.5)};
  for (std::size_t i = 0; i < n; ++i) pairs.y[i] = (pairs.y[i] - 2 * pairs.x[i]) * of_y;
  for (double& x : pairs.x) x *= of_x;
  return pairs;
}

/// Correlated integers far from zero.
Pairs far_pairs(Rng& rng, double offset, std::size_t n) {
  Pairs pairs{shifted_pattern(rng, offset, n), shifted_pattern(rng, offset, n)};
  for (std::size_t i = 0; i < n; ++i) pairs.y[i] += 2 * (pairs.x[i] - offset);
  return pairs;
}

/// Values times a power of two that brings the largest one near 1: no square underflows.
struct Scaled {
  explicit Scaled(Values of) : x(std::move(of)) {
    double most = 0;
    for (const double value : x) most = std::max(most, std::abs(value));
    exponent = most > 0 ? std::ilogb(most) : 0;
    for (double& value : x) value = std::scalbn(value, -exponent);
  }
  Values x;
  int exponent = 0;
};

/// The header's bound, for one pass or two.
void judge_pairs(const std::vector<Pairs>& all, const std::string& rule) {
  Results results;
  for (const auto& [x, y] : all) {
    const Scaled a(x), b(y);
    const auto n = static_cast<double>(x.size());
    const auto of_x = exact_moments(a.x), of_y = exact_moments(b.x);
    const double exact = static_cast<double>(exact_codeviation(a.x, b.x) / (n - 1));
    const double sigma_x = std::sqrt(of_x.variance), sigma_y = std::sqrt(of_y.variance);
    const double mean_x = static_cast<double>(of_x.mean), mean_y = static_cast<double>(of_y.mean);
    const double size =
        std::hypot(sigma_x, mean_x) * sigma_y + std::hypot(sigma_y, mean_y) * sigma_x;
    const auto unscaled = [exponent = a.exponent + b.exponent](double value) {
      return std::scalbn(value, exponent);
    };
    const auto got = MEASURE(covariance, x, y);
    const auto find = [=]() -> std::vector<Suspect> {
      return {
          {unscaled(exact * (n - 1) / n),
           "this divides by n; a sample covariance divides by n - 1 (no integer division)"_likely},
          {unscaled(exact + mean_x * mean_y * n / (n - 1)),
           "this is E{XY} n/(n-1): the means were not subtracted"_likely},
          {sigma_x == 0 || sigma_y == 0 ? nan : unscaled(exact),
           "all values of a list are equal, so that its sigma is 0: do not divide by it"_likely},
          {exact / (sigma_x * sigma_y),
           "this is the correlation: do not divide by the standard deviations"_likely}};
    };
    results.add(got.call, got.value, unscaled(exact), unscaled(10 * n * eps * size), find);
  }
  results.expect(
      "two running means lose at most n eps (kappa x + kappa y) sigma x sigma y; 1 digit of slack",
      rule);
}

}  // namespace
}  // namespace mc::checks
