#pragma once
// What a check may expect of random numbers. Each test has a null hypothesis that holds for every
// right answer, in whatever order it draws; an exact distribution under it; and an alpha, the
// chance that a right answer fails. Each records its p-value, which under the null is uniform, and
// tells its story when it fails: measured, expected, because, likely.
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

#include "checks/support/expect.hpp"

namespace mc::checks {

/// What a random test tests.
struct Null {
  std::string words;  ///< "the estimates of 2.2 have mean E{g}"
  double alpha;       ///< chance of failing a right answer: 1e-8 and the like
};

/// Independent replicates: results of the same estimator from seeds of their own.
struct Replicates {
  std::string call;                ///< the call: "estimates({7, 8, …}, 64)"
  std::span<const double> values;  ///< one a seed
  double n = 1;                    ///< samples behind each of them
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

}  // namespace mc::checks
