#pragma once
// Errors of estimates over stratified points, compared with their exact variances. The integrands
// live here, where the submission cannot see them: it sends points.

#include <array>
#include <functional>

#include "checks/stratification/jitter.hpp"
#include "checks/support/exact_stratified.hpp"

namespace mc::checks {

/// A function of a point, and its name.
struct Tested {
  std::string words;  ///< "exp(x)"
  std::function<double(View)> f;
};

inline double exponential(double x) {
  return std::exp(x);
}
inline double centred_exponential(double x) {
  return std::exp(x - 0.5);
}
inline double gaussian(double x) {
  return std::exp(-x * x);
}
inline double centred(double x) {
  return x - 0.5;
}

/// h(x) + h(y) + …, and h(x) h(y) ….
inline Tested sum_over_axes(std::string words, double (*h)(double)) {
  return {std::move(words), [h](View x) {
            double sum = 0;
            for (const double one : x) sum += h(one);
            return sum;
          }};
}
inline Tested product_over_axes(std::string words, double (*h)(double)) {
  return {std::move(words), [h](View x) {
            double product = 1;
            for (const double one : x) product *= h(one);
            return product;
          }};
}

/// What a right answer's estimates of a function are like at some n.
struct Expected {
  double mean, variance;
  double kurtosis = 3;
  double independent = 0;  ///< variance of the mean of as many independent points
};

/// Of one point in each stratum.
inline Expected expected_of(const WithinStrata& strata, double kurtosis = 3) {
  return {mean_of(strata), stratified_variance(strata), kurtosis,
          independent_variance(strata, strata.size())};
}

/// The mean of g over the first `used` points of each set.
inline Values estimates_over(const Sets& sets, const Tested& g, std::size_t used) {
  Values estimates, point(sets.dims);
  std::vector<View> columns(sets.dims);
  for (std::size_t set = 0; set < sets.size(); ++set) {
    for (std::size_t d = 0; d < sets.dims; ++d) columns[d] = sets.column(set, d);
    double sum = 0;
    for (std::size_t k = 0; k < used; ++k) {
      for (std::size_t d = 0; d < sets.dims; ++d) point[d] = columns[d][k];
      sum += g.f(point);
    }
    estimates.push_back(sum / static_cast<double>(used));
  }
  return estimates;
}

/// Their mean squared error is the exact variance.
inline void expect_level_of_first(const Sets& sets, std::size_t used, const Tested& g,
                                  const Expected& expected, const std::string& words,
                                  const std::string& otherwise) {
  const Values estimates = estimates_over(sets, g, used);
  expect_variance({fmt::format("{}, estimates of {}", sets.call, g.words), estimates,
                   static_cast<double>(used)},
                  expected.mean, expected.variance, expected.kurtosis, {words, alpha},
                  {{{expected.independent / expected.variance,
                     "that is the variance of independent points: nothing is stratified here"}},
                   otherwise});
}
inline void expect_level(const Sets& sets, const Tested& g, const Expected& expected,
                         const std::string& words, const std::string& otherwise) {
  expect_level_of_first(sets, sets.n, g, expected, words, otherwise);
}

/// It falls between two sizes as the exact variances do.
inline void expect_slope(const Sets& few, const Sets& many, const Tested& g,
                         const std::array<Expected, 2>& expected, const std::string& words,
                         const std::string& otherwise) {
  const Values at_few = estimates_over(few, g, few.n), at_many = estimates_over(many, g, many.n);
  const auto known = [](const Expected& at) { return Known{at.mean, at.variance, at.kurtosis}; };
  expect_rate(
      {fmt::format("{}, estimates of {}", few.call, g.words), at_few, static_cast<double>(few.n)},
      known(expected[0]), {many.call, at_many, static_cast<double>(many.n)}, known(expected[1]),
      {words, alpha},
      {{{0.5, "N^-1/2 is the rate of independent points: nothing is stratified here"}}, otherwise});
}

}  // namespace mc::checks
