#pragma once
// What a check may expect of random numbers. Each test has a null hypothesis that holds for every
// right answer, in whatever order it draws; an exact distribution under it; and an alpha, the
// chance that a right answer fails. Each records its p-value, which under the null is uniform.
//
// One run of a lab must not fail a right answer more than once in a million: its alphas add up to
// less than 1e-6, which self_test counts. The distributions are exact for Gaussian errors; a sample
// mean's errors are nearly that, and kurtosis widens what is sensitive to it.
//
// Suspects of a hint are given in the unit of what is measured (a mean, a ratio of variances, an
// exponent, a proportion); one is named where the measured value lies as near to it as a right
// value would to the expected one.

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "checks/support/compare.hpp"
#include "checks/support/measure.hpp"

namespace mc::checks {

/// What a random test tests.
struct Null {
  std::string words;  ///< "the estimates of 2.2 have mean E{g}"
  double alpha;       ///< chance of failing a right answer: 1e-8 and the like
};

/// Hints for a failure: that of the suspect which the measured value equals, else `otherwise`.
struct Hints {
  std::vector<Suspect> suspects;
  std::string otherwise;
};

/// Independent replicates: results of the same estimator with different seeds.
struct Replicates {
  std::string call;                ///< the call: "estimates({7, 8, …}, 64)"
  std::span<const double> values;  ///< one per seed
  double n = 1;                    ///< samples of each of them
};

/// Their mean is `exact`: z, with the exact `variance` of one replicate.
double expect_mean(const Replicates& estimates, double exact, double variance, const Null& null,
                   const Hints& hints);

/// Their mean squared error about `exact` is `variance`: the sum of squares over the variance is
/// chi-squared with as many degrees of freedom as there are replicates. `kurtosis` is that of one
/// replicate (a Gaussian's is 3; the mean of n samples of kurtosis k has 3 + (k - 3)/n): with
/// another one the degrees are 2R/(kurtosis - 1), which gives the sum its true variance
/// (Satterthwaite 1946). Measured is the ratio to `variance`.
double expect_variance(const Replicates& estimates, double exact, double variance, double kurtosis,
                       const Null& null, const Hints& hints);

/// What is known of an estimator at some n.
struct Known {
  double exact;         ///< the true value
  double variance;      ///< of one replicate
  double kurtosis = 3;  ///< of one replicate
};

/// `count` of `trials` independent events of probability `p` happened: exact binomial. `event` says
/// what happened: "the interval held the true mean". Measured is the proportion. (The recorded
/// p-value is spread over the jump of the distribution at `count`, so that it is uniform; the
/// verdict is by the whole jump.)
double expect_proportion(const std::string& call, const std::string& event, std::uint64_t count,
                         std::uint64_t trials, double p, const Null& null, const Hints& hints);

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
