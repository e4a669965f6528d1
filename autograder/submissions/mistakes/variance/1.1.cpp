// Mistakes in task 1.1.
#include "variance.hpp"

#include <numeric>

#define mean(x) right_mean(x)
#include "solutions/variance.cpp"
#undef mean

// mistake: starts the sum with the first value, which an empty list does not have
// hint: an empty list where a value is needed
namespace mc::mean_from_the_first_value {
double mean(std::span<const double> x) {
  double sum = x[0];
  for (const double value : x.subspan(1)) sum += value;
  return sum / static_cast<double>(x.size());
}
}  // namespace mc::mean_from_the_first_value

// mistake: sums in a float
// hint: only about seven digits are correct, as in a float
// hint: a float overflows at 3.4e38
namespace mc::mean_in_float {
double mean(std::span<const double> x) {
  float sum = 0;
  for (double value : x) sum += static_cast<float>(value);
  return sum / static_cast<float>(x.size());
}
}  // namespace mc::mean_in_float

// mistake: starts std::accumulate with 0, an int, and so sums in int
// hint: the sum is truncated to an integer at each step
namespace mc::mean_in_whole_numbers {
double mean(std::span<const double> x) {
  return std::accumulate(x.begin(), x.end(), 0) / static_cast<double>(x.size());
}
}  // namespace mc::mean_in_whole_numbers

// mistake: returns 0 as the mean of no values
// hint: quiet_NaN() if the result is undefined
namespace mc::mean_of_nothing_is_zero {
double mean(std::span<const double> x) {
  return x.empty() ? 0 : right_mean(x);
}
}  // namespace mc::mean_of_nothing_is_zero

// mistake: divides the sum by n - 1, as the variance does
// hint: this divides by n - 1; only a variance does
namespace mc::mean_over_n_minus_1 {
double mean(std::span<const double> x) {
  if (x.empty()) return nan;
  const auto n = static_cast<double>(x.size());
  double sum = 0;
  for (double value : x) sum += value / (n - 1);
  return sum;
}
}  // namespace mc::mean_over_n_minus_1

// mistake: sums all values first, which overflows where the mean does not
// hint: the sum overflows although the mean does not
namespace mc::mean_overflows {
double mean(std::span<const double> x) {
  double sum = 0;
  for (double value : x) sum += value;
  return sum / static_cast<double>(x.size());
}
}  // namespace mc::mean_overflows

// mistake: checks the sum only for +infinity
// hint: a sum can also overflow to -inf
namespace mc::mean_overflows_below {
double mean(std::span<const double> x) {
  double sum = 0;
  for (double value : x) sum += value;
  return sum == std::numeric_limits<double>::infinity() ? right_mean(x)
                                                        : sum / static_cast<double>(x.size());
}
}  // namespace mc::mean_overflows_below

// mistake: ignores NaN and infinities
// hint: is infinite or NaN
namespace mc::mean_skips_nan {
double mean(std::span<const double> x) {
  std::vector<double> numbers;
  std::copy_if(x.begin(), x.end(), std::back_inserter(numbers),
               [](double value) { return std::isfinite(value); });
  return right_mean(numbers);
}
}  // namespace mc::mean_skips_nan

// mistake: counts only values that are not 0
// hint: divide by their number
namespace mc::mean_skips_zeros {
double mean(std::span<const double> x) {
  std::vector<double> numbers;
  std::copy_if(x.begin(), x.end(), std::back_inserter(numbers),
               [](double value) { return value != 0; });
  return right_mean(numbers);
}
}  // namespace mc::mean_skips_zeros

// mistake: divides by the largest value before it adds, not by the largest magnitude
// hint: a sum can overflow
namespace mc::mean_over_the_largest {
double mean(std::span<const double> x) {
  const double right = right_mean(x);
  double sum = 0;
  for (const double value : x) sum += value;
  if (x.empty() || std::isfinite(sum) || !std::isfinite(right)) return right;
  const double largest = *std::max_element(x.begin(), x.end());
  double scaled = 0;
  for (const double value : x) scaled += value / largest;
  return scaled / static_cast<double>(x.size()) * largest;
}
}  // namespace mc::mean_over_the_largest
