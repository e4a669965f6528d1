#pragma once
// Statistical tests. Each has a null hypothesis that holds for every correct answer, in whatever
// order it draws; an exact distribution under it; and an alpha, the probability that a correct
// answer fails. Each records its p-value, which is uniform under the null.
//
// The alphas of a lab sum to less than 1e-6, which self_test verifies. The distributions are exact
// for Gaussian errors; those of a sample mean are nearly Gaussian, and expect_variance() takes the
// kurtosis into account.
//
// Suspects have the unit of the measured statistic (a mean, a ratio of variances, a proportion).
// One is named if the measured value is as close to it as a correct value is to the expected one.

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "checks/support/compare.hpp"
#include "checks/support/measure.hpp"

namespace mc::checks {

struct Null {
  std::string words;  ///< "the estimates of 2.2 have mean E{g}"
  double alpha;       ///< the probability of failing a correct answer, such as 1e-8
};

/// The hint for a failure is that of the suspect that the measured value equals, or `rule`.
struct Hints {
  std::vector<Suspect> suspects;
  std::string rule;
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

/// Their mean squared error about `exact` is `variance`: the sum of R squares over the variance is
/// chi-squared with R degrees of freedom, or with 2R/(kurtosis - 1), which gives the sum its true
/// variance (Satterthwaite 1946). `kurtosis` is that of one replicate (a Gaussian's is 3; the mean
/// of n samples of kurtosis k has 3 + (k - 3)/n). The statistic is the ratio to `variance`.
double expect_variance(const Replicates& estimates, double exact, double variance, double kurtosis,
                       const Null& null, const Hints& hints);

/// The exact moments of an estimator for some n.
struct Known {
  double exact;         ///< the true value
  double variance;      ///< of one replicate
  double kurtosis = 3;  ///< of one replicate
};

/// `count` of `trials` independent events of probability `p` happened: exact binomial. `event` says
/// what happened: "the interval contained the true mean". The statistic is the proportion. (The
/// recorded p-value, not the verdict, is randomized within the jump of the distribution at
/// `count`.)
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

/// The mean of n independent values: the excess kurtosis falls as 1/n.
inline Known mean_of(const Population& x, double n) {
  return {x.mean, x.variance / n, 3 + (x.kurtosis - 3) / n};
}

}  // namespace mc::checks
