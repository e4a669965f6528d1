#pragma once
// What is known of a random variable, and of the mean of n independent ones.

#include "checks/support/statistics.hpp"

namespace mc::checks {

/// Mean, variance, and kurtosis E{(X - mean)^4} / variance^2 (a Gaussian's is 3).
struct Population {
  double mean = 0, variance = 0, kurtosis = 3;
};

/// From the raw moments E{X}, E{X^2}, E{X^3}, E{X^4}.
inline Population population(double m1, double m2, double m3, double m4) {
  const double variance = m2 - m1 * m1;
  const double fourth = m4 - 4 * m1 * m3 + 6 * m1 * m1 * m2 - 3 * m1 * m1 * m1 * m1;
  return {m1, variance, fourth / (variance * variance)};
}

/// Of the mean of n independent values: the excess over a Gaussian's kurtosis falls as 1/n.
inline Known mean_of(const Population& x, double n) {
  return {x.mean, x.variance / n, 3 + (x.kurtosis - 3) / n};
}

}  // namespace mc::checks
