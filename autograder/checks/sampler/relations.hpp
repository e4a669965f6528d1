#pragma once
// What columns of numbers in [0,1) must not have to do with each other.

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>

#include "checks/sampler/samplers.hpp"

namespace mc::checks {

/// Two columns, one of them in a random order of its own, have nothing to do with each other. Then
/// the sum of products has mean 0 and variance Sxx Syy / (N - 1), exactly; its distribution is that
/// of a rank correlation, normal for a thousand samples but for tails that are lighter still. 6.8
/// standard deviations: one pair in 1e11 fails; fewer than two thousand are looked at. Orders that
/// are not uniform permutations have another `variance` than 1 / (N - 1), by this factor at most.
inline void check_unrelated(const std::string& call, View x, View y, const std::string& which,
                            const std::string& hint, double variance = 1) {
  const auto n = static_cast<double>(x.size());
  const double mean_x = std::accumulate(x.begin(), x.end(), 0.0) / n;
  const double mean_y = std::accumulate(y.begin(), y.end(), 0.0) / n;
  double xx = 0, yy = 0, xy = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    xx += (x[i] - mean_x) * (x[i] - mean_x);
    yy += (y[i] - mean_y) * (y[i] - mean_y);
    xy += (x[i] - mean_x) * (y[i] - mean_y);
  }
  const double correlation = xy / std::sqrt(xx * yy), most = 6.8 * std::sqrt(variance / (n - 1));
  if (std::abs(correlation) <= most) return;  // false for NaN: a column of equal numbers
  expect_that(
      false, fmt::format("{}: {} have a correlation of {:.3f}", call, which, correlation),
      fmt::format("between -{0:.3f} and {0:.3f}", most),
      "columns in independent random permutations are uncorrelated, up to a standard deviation "
      "of 1/sqrt(N - 1)",
      hint);
}

/// No number comes twice. Of n numbers of 53 random bits two are the same with probability
/// n^2 / 2^54: 4e-9 for 8,000.
inline void check_all_different(const std::string& call, Values numbers, const std::string& which,
                                const std::string& hint) {
  const std::size_t count = numbers.size();
  std::sort(numbers.begin(), numbers.end());
  const auto twice = std::adjacent_find(numbers.begin(), numbers.end());
  if (twice == numbers.end()) return pass();
  expect_that(false, fmt::format("{}: {:.17g} comes more than once in {}", call, *twice, which),
              fmt::format("{} different numbers", count),
              "two numbers of 53 random bits are the same once in 1e16", hint);
}

}  // namespace mc::checks
