// Mistakes in task 1.3.
#include "variance.hpp"

#include <numeric>

#define variance_two_pass right_variance_two_pass
#include "solutions/variance.cpp"
#undef variance_two_pass

namespace mc {
namespace {

/// One pass about `shift`.
double variance_about(std::span<const double> x, double shift) {
  const auto n = static_cast<double>(x.size());
  double sum = 0, squares = 0;
  for (double value : x) {
    const double d = value - shift;
    sum += d;
    squares += d * d;
  }
  return std::max(squares - sum * sum / n, 0.0) / (n - 1);
}

template <std::size_t lanes, class Term>
double sum_in_lanes(std::span<const double> x, Term term) {
  double sums[lanes] = {};
  for (std::size_t i = 0; i < x.size(); ++i) sums[i % lanes] += term(x[i]);
  return std::accumulate(sums, sums + lanes, 0.0);
}

/// Two corrected passes, which may give less than 0.
template <std::size_t lanes>
double corrected_variance(std::span<const double> x) {
  if (x.size() < 2) return nan;
  const auto n = static_cast<double>(x.size());
  const double center = sum_in_lanes<lanes>(x, [](double value) { return value; }) / n;
  const double m2 = sum_in_lanes<lanes>(x, [=](double v) { return (v - center) * (v - center); });
  const double correction = sum_in_lanes<lanes>(x, [=](double value) { return value - center; });
  return (m2 - correction * correction / n) / (n - 1);
}

}  // namespace
}  // namespace mc

// mistake: returns the standard deviation instead of the variance
// hint: this is the standard deviation
namespace mc::standard_deviation {
double variance_two_pass(std::span<const double> x) {
  return std::sqrt(right_variance_two_pass(x));
}
}  // namespace mc::standard_deviation

// mistake: lets the correction make the variance of constant data negative
// hint: the rounded correction may exceed the sum: then return 0
namespace mc::two_pass_below_zero {
double variance_two_pass(std::span<const double> x) {
  return corrected_variance<1>(x);
}
}  // namespace mc::two_pass_below_zero

// mistake: lets the correction make the variance of constant data negative, with sums in four lanes
// hint: the rounded correction may exceed the sum: then return 0
namespace mc::two_pass_below_zero_in_lanes {
double variance_two_pass(std::span<const double> x) {
  return corrected_variance<4>(x);
}
}  // namespace mc::two_pass_below_zero_in_lanes

// mistake: limits m2 by std::max(0.0, m2), which is 0 for NaN
// hint: std::max(0.0, NaN) is 0
namespace mc::two_pass_hides_nan {
double variance_two_pass(std::span<const double> x) {
  if (x.size() < 2) return nan;
  return std::max(0.0, right_variance_two_pass(x));
}
}  // namespace mc::two_pass_hides_nan

// mistake: implements the textbook formula
// hint: this has the rounding errors of E{X^2} - E{X}^2
namespace mc::two_pass_is_textbook {
double variance_two_pass(std::span<const double> x) {
  return variance_textbook(x);
}
}  // namespace mc::two_pass_is_textbook

// mistake: uses one pass instead of two: the mean is rounded at every value
// hint: this has the rounding errors of a running mean
namespace mc::two_pass_is_welford {
double variance_two_pass(std::span<const double> x) {
  Moments all;
  for (double value : x) add(all, value);
  return variance(all);
}
}  // namespace mc::two_pass_is_welford

// mistake: returns 0 as the variance of one value
// hint: quiet_NaN() if the result is undefined
namespace mc::two_pass_of_one_is_zero {
double variance_two_pass(std::span<const double> x) {
  return x.size() < 2 ? 0 : right_variance_two_pass(x);
}
}  // namespace mc::two_pass_of_one_is_zero

// mistake: divides by n instead of n - 1
// hint: a sample variance divides by n - 1
namespace mc::two_pass_over_n {
double variance_two_pass(std::span<const double> x) {
  const auto n = static_cast<double>(x.size());
  return right_variance_two_pass(x) * ((n - 1) / n);
}
}  // namespace mc::two_pass_over_n

// mistake: uses one pass about the first value, which may be far from the others
// hint: sums relative to the first value, which may be far
namespace mc::two_pass_shift_by_first {
double variance_two_pass(std::span<const double> x) {
  return x.size() < 2 ? nan : variance_about(x, x.front());
}
}  // namespace mc::two_pass_shift_by_first

// mistake: uses one pass about the last value, which may be far from the others
// hint: sums relative to the last value, which may be far
namespace mc::two_pass_shift_by_last {
double variance_two_pass(std::span<const double> x) {
  return x.size() < 2 ? nan : variance_about(x, x.back());
}
}  // namespace mc::two_pass_shift_by_last

// mistake: uses one pass about the middle value, which may be far from the others
// hint: sums relative to the middle value, which may be far
namespace mc::two_pass_shift_by_middle {
double variance_two_pass(std::span<const double> x) {
  return x.size() < 2 ? nan : variance_about(x, x[x.size() / 2]);
}
}  // namespace mc::two_pass_shift_by_middle

// mistake: uses two passes without the correction for the rounded mean
// hint: the mean was rounded: subtract (sum of deviations)^2 / n
namespace mc::two_pass_uncorrected {
double variance_two_pass(std::span<const double> x) {
  if (x.size() < 2) return nan;
  const double center = mean(x);
  double m2 = 0;
  for (double value : x) m2 += (value - center) * (value - center);
  return m2 / static_cast<double>(x.size() - 1);
}
}  // namespace mc::two_pass_uncorrected

// mistake: computes n / (n - 1) as integers, which is 1 from n = 3 on
// hint: n/(n-1) was an integer division
namespace mc::two_pass_whole_division {
double variance_two_pass(std::span<const double> x) {
  const std::size_t n = x.size();
  if (n < 2) return nan;
  const double m2 = right_variance_two_pass(x) * static_cast<double>(n - 1);
  return m2 / static_cast<double>(n) * static_cast<double>(n / (n - 1));
}
}  // namespace mc::two_pass_whole_division

// mistake: treats a variance below 1e-12 as zero, whatever the scale of the data
// hint: small is not zero
namespace mc::two_pass_with_threshold {
double variance_two_pass(std::span<const double> x) {
  const double variance = right_variance_two_pass(x);
  return variance < 1e-12 ? 0 : variance;
}
}  // namespace mc::two_pass_with_threshold

// mistake: divides the sum, which overflows for large values
// hint: take the mean of 1.1
namespace mc::two_pass_sum_overflows {
double variance_two_pass(std::span<const double> x) {
  const double sum = std::accumulate(x.begin(), x.end(), 0.0);
  return std::isfinite(sum) ? right_variance_two_pass(x) : nan;
}
}  // namespace mc::two_pass_sum_overflows
