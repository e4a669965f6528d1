#pragma once
// An estimate is judged by what it saw: the points and values of the very evaluations that it made
// say, to the last digits, what it must come to. So nothing but evaluating g at random points gives
// the right answer: that the estimate is unbiased, and has the variance sigma^2 / n, follows.

#include "checks/independent/functions.hpp"

namespace mc::checks {

/// An estimate, and what it is the mean of.
struct Traced {
  std::string call;
  Estimate estimate;
  Values values, points;
};

/// Of n samples of g. Ends the check where g was not evaluated n times: or once more or once less,
/// which the check that counts evaluations has a word for.
Traced traced(const Function& g, std::uint64_t n, Rng& rng);

/// Estimates are the means of their values, but for what n additions lose: `suspects` are those of
/// one task alone.
void add_mean(Results& means, const Traced& seen, Results::FindSuspects suspects = {});
void expect_means(Results& means);

/// Standard errors are s / sqrt(n) of the values, with the digits that a one-pass variance keeps;
/// NaN for one value.
void add_error(Results& errors, const Traced& seen, Results::FindSuspects suspects = {});
void expect_errors(Results& errors);

}  // namespace mc::checks
