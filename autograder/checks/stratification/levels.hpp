#pragma once
// Errors of estimates over stratified points, compared with their exact variances. The integrands
// are defined here, where the submission cannot see them: it sends points.

#include <functional>

#include "checks/stratification/common.hpp"
#include "checks/support/exact_stratified.hpp"
#include "checks/support/statistics.hpp"

namespace mc::checks {

/// A function of a point, and what a right answer's estimates of it are like at some n.
struct Level {
  std::string words;  ///< "exp(x)"
  std::function<double(View)> f;
  double mean, variance;
  double kurtosis = 3;
  double independent = 0;  ///< variance of the mean of as many independent points
  std::string because = "one point in each stratum leaves the variance within the strata";
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
inline auto sum_over_axes(double (*h)(double)) {
  return [h](View x) {
    double sum = 0;
    for (const double one : x) sum += h(one);
    return sum;
  };
}
inline auto product_over_axes(double (*h)(double)) {
  return [h](View x) {
    double product = 1;
    for (const double one : x) product *= h(one);
    return product;
  };
}

/// Of one point in each stratum.
inline Level level_of(std::string words, std::function<double(View)> f, const WithinStrata& strata,
                      double kurtosis = 3) {
  return {std::move(words), std::move(f),
          mean_of(strata),  stratified_variance(strata),
          kurtosis,         independent_variance(strata, strata.size())};
}

/// The mean squared error of estimates over the first `used` points of each set (0: all of them)
/// is the exact variance.
inline void expect_level(const Sets& sets, const Level& level, std::size_t used = 0) {
  if (used == 0) used = sets.n;
  Values estimates, point(sets.dims);
  for (std::size_t set = 0; set < sets.size(); ++set) {
    std::vector<View> columns;
    for (std::size_t d = 0; d < sets.dims; ++d) columns.push_back(sets.column(set, d));
    double sum = 0;
    for (std::size_t k = 0; k < used; ++k) {
      for (std::size_t d = 0; d < sets.dims; ++d) point[d] = columns[d][k];
      sum += level.f(point);
    }
    estimates.push_back(sum / static_cast<double>(used));
  }
  expect_variance(
      {fmt::format("{}, estimates of {}", sets.call, level.words), estimates,
       static_cast<double>(used)},
      level.mean, level.variance, level.kurtosis,
      {fmt::format("the error of {} over {} points: {}", level.words, used, level.because), alpha},
      {{{level.independent / level.variance,
         "that is the variance of independent points: nothing is stratified here"}},
       "is each point uniform in its stratum, and independent of the others?"});
}

}  // namespace mc::checks
