// Mistakes in task 1.8.
#include "variance.hpp"

#define moments right_moments
#include "solutions/variance.cpp"
#undef moments

namespace mc {
namespace {

/// One pass about `shift`.
Moments moments_about(std::span<const double> x, double shift) {
  const auto n = static_cast<double>(x.size());
  double sum = 0, squares = 0;
  for (double value : x) {
    sum += value - shift;
    squares += (value - shift) * (value - shift);
  }
  return {x.size(), shift + sum / n, squares - sum * sum / n};
}

}  // namespace
}  // namespace mc

// mistake: uses the textbook formula, because one pass is fast
// hint: this has the rounding errors of E{X^2} - E{X}^2
namespace mc::moments_are_textbook {
Moments moments(std::span<const double> x) {
  return x.empty() ? Moments{} : moments_about(x, 0);
}
}  // namespace mc::moments_are_textbook

// mistake: uses Welford's update, whose running mean is rounded at the scale of the data
// hint: this has the rounding errors of a running mean
namespace mc::moments_are_welford {
Moments moments(std::span<const double> x) {
  Moments all;
  for (double value : x) add(all, value);
  return all;
}
}  // namespace mc::moments_are_welford

// mistake: skips the values that do not fill a last block of 16
// hint: including those of a shorter last block
namespace mc::moments_drop_the_last_block {
Moments moments(std::span<const double> x) {
  return right_moments(x.first(x.size() / 16 * 16));
}
}  // namespace mc::moments_drop_the_last_block

// mistake: limits m2 by std::max(0.0, m2), which is 0 for NaN
// hint: std::max(0.0, NaN) is 0
namespace mc::moments_hide_nan {
Moments moments(std::span<const double> x) {
  Moments all = right_moments(x);
  all.m2 = std::max(0.0, all.m2);
  return all;
}
}  // namespace mc::moments_hide_nan

// mistake: sums in float lanes, twice as many per register
// hint: use double everywhere
namespace mc::moments_in_float_lanes {
Moments moments(std::span<const double> x) {
  if (x.empty()) return {};
  float sum = 0, m2 = 0;
  for (double value : x) sum += static_cast<float>(value - x[0]);
  const float offset = sum / static_cast<float>(x.size());
  for (double value : x) {
    const float deviation = static_cast<float>(value - x[0]) - offset;
    m2 += deviation * deviation;
  }
  return {x.size(), x[0] + offset, m2};
}
}  // namespace mc::moments_in_float_lanes

// mistake: shifts the data but does not shift the mean back
// hint: add the shift back
namespace mc::moments_leave_the_shift {
Moments moments(std::span<const double> x) {
  Moments all = right_moments(x);
  if (!x.empty()) all.mean -= x[0];
  return all;
}
}  // namespace mc::moments_leave_the_shift

// mistake: merges blocks by their means, each rounded at the scale of the data
// hint: do not subtract a rounded mean
namespace mc::moments_merge_rounded_means {
Moments moments(std::span<const double> x) {
  Moments all;
  for (std::size_t first = 0; first < x.size(); first += block_size) {
    const auto block = x.subspan(first, std::min(block_size, x.size() - first));
    all = merge(all, right_moments(block));
  }
  return all;
}
}  // namespace mc::moments_merge_rounded_means

// mistake: returns mean and m2 with a count of 0
// hint: the count stays 0
namespace mc::moments_never_count {
Moments moments(std::span<const double> x) {
  const Moments all = right_moments(x);
  return {0, all.mean, all.m2};
}
}  // namespace mc::moments_never_count

// mistake: divides by the count even if it is 0
// hint: return Moments{} for an empty list
namespace mc::moments_of_nothing_are_nan {
Moments moments(std::span<const double> x) {
  return x.empty() ? Moments{0, nan, nan} : right_moments(x);
}
}  // namespace mc::moments_of_nothing_are_nan

// mistake: uses one pass about the median of three values, all of which may be far from the others
// hint: far from all others
namespace mc::moments_shift_by_one_of_three {
Moments moments(std::span<const double> x) {
  if (x.empty()) return {};
  const double first = x.front(), middle = x[x.size() / 2], last = x.back();
  const double shift = std::max(std::min(first, middle), std::min(std::max(first, middle), last));
  Moments all = moments_about(x, shift);
  if (all.m2 < 0) all.m2 = 0;
  return all;
}
}  // namespace mc::moments_shift_by_one_of_three

// mistake: sums in blocks and lanes about the first value, which may be far from the others
// hint: do not measure from a value that may be far
namespace mc::moments_shift_by_the_first_in_blocks {
Moments moments(std::span<const double> x) {
  if (x.empty()) return {};
  Moments all;
  for (std::size_t first = 0; first < x.size(); first += block_size) {
    const std::size_t size = std::min(block_size, x.size() - first);
    all = merge(all, moments_from(x[0], x.subspan(first, size)));
  }
  all.mean += x[0];
  return all;
}
}  // namespace mc::moments_shift_by_the_first_in_blocks

// mistake: shifts by the mean of 32 values at equal distances, which may all be outliers
// hint: far from all others
namespace mc::moments_shift_by_32_places {
Moments moments(std::span<const double> x) {
  if (x.empty()) return {};
  double shift = 0, least = x[0], most = x[0];
  if (x.size() < 64) return right_moments(x);
  for (std::size_t i = 0; i < 32; ++i) {
    const double value = x[i * (x.size() / 32)];
    shift += value / 30;
    least = std::min(least, value);
    most = std::max(most, value);
  }
  return moments_about(x, shift - least / 30 - most / 30);
}
}  // namespace mc::moments_shift_by_32_places
