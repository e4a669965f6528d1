// Mistakes in task 2.5.
#include "independent.hpp"

#define confidence_interval right_confidence_interval
#include "solutions/independent.cpp"
#undef confidence_interval

// mistake: uses the 95 % quantile, whatever the level
// hint: 1.96 is for a level of 95 % only
namespace mc::always_two {
Interval confidence_interval(const Estimate& estimate, double level) {
  if (!(level > 0 && level < 1)) throw std::invalid_argument("level: must lie inside (0, 1)");
  const double reach = 1.96 * estimate.standard_error;
  return {estimate.value - reach, estimate.value + reach};
}
}  // namespace mc::always_two

// mistake: divides the standard error of the mean by the square root of n again
// hint: standard_error is that of the mean: it is already divided by sqrt(n)
namespace mc::knows_n_twice {
Interval confidence_interval(const Estimate& estimate, double level) {
  if (!(level > 0 && level < 1)) throw std::invalid_argument("level: must lie inside (0, 1)");
  const double s = estimate.standard_error / std::sqrt(static_cast<double>(estimate.n));
  const double reach = -normal_quantile((1 - level) / 2) * s;
  return {estimate.value - reach, estimate.value + reach};
}
}  // namespace mc::knows_n_twice

// mistake: uses the one-sided quantile of the level
// hint: the interval excludes two tails
namespace mc::one_sided_interval {
Interval confidence_interval(const Estimate& estimate, double level) {
  if (!(level > 0 && level < 1)) throw std::invalid_argument("level: must lie inside (0, 1)");
  const double reach = normal_quantile(level) * estimate.standard_error;
  return {estimate.value - reach, estimate.value + reach};
}
}  // namespace mc::one_sided_interval

// mistake: uses the quantile of the lower tail, which is negative: low and high are swapped
// hint: low and high are swapped
namespace mc::quantile_of_the_lower_tail {
Interval confidence_interval(const Estimate& estimate, double level) {
  if (!(level > 0 && level < 1)) throw std::invalid_argument("level: must lie inside (0, 1)");
  const double reach = normal_quantile((1 - level) / 2) * estimate.standard_error;
  return {estimate.value - reach, estimate.value + reach};
}
}  // namespace mc::quantile_of_the_lower_tail

// mistake: z standard errors is the whole length
// hint: the interval has half of its length
namespace mc::interval_of_half_length {
Interval confidence_interval(const Estimate& estimate, double level) {
  const Interval right = right_confidence_interval(estimate, level);
  const double reach = (right.high - right.low) / 4;
  return {estimate.value - reach, estimate.value + reach};
}
}  // namespace mc::interval_of_half_length

// mistake: returns the estimate as both ends
// hint: the interval has length 0
namespace mc::interval_of_length_zero {
Interval confidence_interval(const Estimate& estimate, double level) {
  right_confidence_interval(estimate, level);
  return {estimate.value, estimate.value};
}
}  // namespace mc::interval_of_length_zero
