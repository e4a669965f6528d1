#pragma once
// The null distributions of the statistics that random checks are judged by.

#include <cstdint>
#include <functional>
#include <vector>

#include "common/estimation.hpp"

namespace mc::checks {

/// Both tails of a distribution at a value x. Each keeps its relative accuracy (1e-9 or better,
/// down to 1e-300), which 1 - the other one would not.
struct Tails {
  double lower = 0;  ///< P(X <= x)
  double upper = 0;  ///< P(X >= x)

  /// How likely something at least as extreme is, on either side: uniform in [0, 1] where X is
  /// continuous. NaN counts as impossible.
  double two_sided() const;
};

/// Standard normal.
Tails normal_tails(double z);

/// Chi-squared with `degrees` > 0 degrees of freedom, not necessarily whole.
Tails chi_squared_tails(double x, double degrees);

/// Fisher's F: the ratio of two independent chi-squared, each over its degrees of freedom.
Tails f_tails(double x, double degrees_above, double degrees_below);

/// `k` successes in `n` trials that succeed with probability `p` in [0, 1]. Discrete: both tails
/// hold the probability of k itself.
Tails binomial_tails(std::uint64_t k, std::uint64_t n, double p);

/// Kolmogorov's D, the largest distance of the empirical distribution function of `n` independent
/// values from the true one. Tails within 0.2 % for n >= 100.
Tails kolmogorov_tails(double d, std::uint64_t n);

/// Sorts fewer than 2^32 finite values, fast where they are about uniform in [0, 1).
void sort_uniforms(std::vector<double>& values);

/// That distance, of values that should be uniform in [0, 1). Sorts them.
double distance_from_uniform(std::vector<double>& values);

/// The values in [low, high] whose two_sided() is at least `alpha`, for tails that are monotone in
/// between: by bisection, to 12 digits.
Interval central_interval(const std::function<Tails(double)>& tails, double alpha, double low,
                          double high);

}  // namespace mc::checks
