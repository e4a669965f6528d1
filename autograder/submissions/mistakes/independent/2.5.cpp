// Mistakes in task 2.5.
#include "independent.hpp"

#define confidence_interval right_confidence_interval
#include "solutions/independent.cpp"
#undef confidence_interval

namespace mc {
namespace {

Interval around(const Estimate& estimate, double level, double reach) {
  right_confidence_interval(estimate, level);  // for what it refuses
  return {estimate.value - reach, estimate.value + reach};
}

}  // namespace
}  // namespace mc

// mistake: uses the 95 % quantile, whatever the level
// hint: 1.96 is for a level of 95 % only
namespace mc::always_two {
Interval confidence_interval(const Estimate& estimate, double level) {
  return around(estimate, level, 1.96 * estimate.standard_error);
}
}  // namespace mc::always_two

// mistake: divides the standard error of the mean by the square root of n again
// hint: standard_error is that of the mean: it is already divided by sqrt(n)
namespace mc::knows_n_twice {
Interval confidence_interval(const Estimate& estimate, double level) {
  const double s = estimate.standard_error / std::sqrt(static_cast<double>(estimate.n));
  return around(estimate, level, normal_quantile((1 + level) / 2) * s);
}
}  // namespace mc::knows_n_twice

// mistake: uses the one-sided quantile of the level
// hint: the interval excludes two tails
namespace mc::one_sided_interval {
Interval confidence_interval(const Estimate& estimate, double level) {
  return around(estimate, level, normal_quantile(level) * estimate.standard_error);
}
}  // namespace mc::one_sided_interval

// mistake: uses the quantile of the lower tail, which is negative: low and high are swapped
// hint: low and high are swapped
namespace mc::quantile_of_the_lower_tail {
Interval confidence_interval(const Estimate& estimate, double level) {
  const double z = normal_quantile((1 - level) / 2);
  return around(estimate, level, z * estimate.standard_error);
}
}  // namespace mc::quantile_of_the_lower_tail

// mistake: z standard errors is the whole length
// hint: the interval has half of its length
namespace mc::interval_of_half_length {
Interval confidence_interval(const Estimate& estimate, double level) {
  const Interval right = right_confidence_interval(estimate, level);
  return around(estimate, level, (right.high - right.low) / 4);
}
}  // namespace mc::interval_of_half_length

// mistake: returns the estimate as both ends
// hint: the interval has length 0
namespace mc::interval_of_length_zero {
Interval confidence_interval(const Estimate& estimate, double level) {
  return around(estimate, level, 0);
}
}  // namespace mc::interval_of_length_zero
