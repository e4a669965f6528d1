#pragma once
// The null distributions of the statistics that judge random numbers.

#include <cstdint>
#include <functional>
#include <vector>

#include "common/estimation.hpp"

namespace mc::checks {

/// Both tails of a distribution at a value x, each with a relative accuracy of 1e-9 or better, down
/// to 1e-300: 1 minus the other tail would be less accurate.
struct Tails {
  double lower = 0;  ///< P(X <= x)
  double upper = 0;  ///< P(X >= x)

  /// The two-sided p-value: uniform in [0, 1] if X is continuous. 0 for NaN.
  double two_sided() const;
};

Tails normal_tails(double z);

/// Chi-squared with `degrees` > 0 degrees of freedom, not necessarily an integer.
Tails chi_squared_tails(double x, double degrees);

/// Fisher's F: the ratio of two independent chi-squared, each over its degrees of freedom.
Tails f_tails(double x, double degrees_above, double degrees_below);

/// `k` successes in `n` trials of probability `p` in [0, 1]. Both tails include k.
Tails binomial_tails(std::uint64_t k, std::uint64_t n, double p);

/// Kolmogorov's D, the largest difference between the empirical distribution function of `n`
/// independent values and the true one. Tails are accurate to 0.2 % for n >= 100.
Tails kolmogorov_tails(double d, std::uint64_t n);

/// Sorts fewer than 2^32 finite values; fast if they are about uniform in [0, 1).
void sort_uniforms(std::vector<double>& values);

/// Kolmogorov's D for values that should be uniform in [0, 1). Sorts them.
double distance_from_uniform(std::vector<double>& values);

/// The values in [low, high] whose two_sided() is at least `alpha`, by bisection, to 12 digits.
Interval central_interval(const std::function<Tails(double)>& tails, double alpha, double low,
                          double high);

}  // namespace mc::checks
