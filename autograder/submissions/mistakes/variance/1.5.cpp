// Mistakes in task 1.5.
#include "variance.hpp"

#define merge right_merge
#include "solutions/variance.cpp"
#undef merge

// mistake: adds the counts as doubles, which are rounded above 2^53
// hint: add the counts as 64-bit integers
namespace mc::merge_adds_counts_in_double {
Moments merge(const Moments& a, const Moments& b) {
  Moments all = right_merge(a, b);
  all.count =
      static_cast<std::uint64_t>(static_cast<double>(a.count) + static_cast<double>(b.count));
  return all;
}
}  // namespace mc::merge_adds_counts_in_double

// mistake: measures both parts from their common mean, after rounding it
// hint: both parts were measured from the merged mean, which is rounded
namespace mc::merge_by_rounded_mean {
Moments merge(const Moments& a, const Moments& b) {
  Moments all = right_merge(a, b);
  const double from_a = a.mean - all.mean;
  const double from_b = b.mean - all.mean;
  all.m2 = a.m2 + static_cast<double>(a.count) * from_a * from_a +  //
           b.m2 + static_cast<double>(b.count) * from_b * from_b;
  return all;
}
}  // namespace mc::merge_by_rounded_mean

// mistake: adds the distance of the two means, not its square
// hint: the distance of the means must be squared
namespace mc::merge_distance_not_squared {
Moments merge(const Moments& a, const Moments& b) {
  Moments all = right_merge(a, b);
  if (a.count == 0 || b.count == 0) return all;
  const auto n_a = static_cast<double>(a.count), n_b = static_cast<double>(b.count);
  all.m2 = a.m2 + b.m2 + std::abs(b.mean - a.mean) * (n_a / (n_a + n_b) * n_b);
  return all;
}
}  // namespace mc::merge_distance_not_squared

// mistake: divides n_a n_b by n as integers
// hint: n_a n_b / n was an integer division
namespace mc::merge_divides_whole_counts {
Moments merge(const Moments& a, const Moments& b) {
  Moments all = right_merge(a, b);
  if (a.count == 0 || b.count == 0) return all;
  const double apart = b.mean - a.mean;
  all.m2 = a.m2 + b.m2 + apart * apart * static_cast<double>(a.count * b.count / all.count);
  return all;
}
}  // namespace mc::merge_divides_whole_counts

// mistake: averages the two means, whatever the counts
// hint: the mean of two means is correct only for equal counts
namespace mc::merge_mean_of_means {
Moments merge(const Moments& a, const Moments& b) {
  Moments all = right_merge(a, b);
  if (a.count > 0 && b.count > 0) all.mean = (a.mean + b.mean) / 2;
  return all;
}
}  // namespace mc::merge_mean_of_means

// mistake: multiplies the counts as integers, which overflow 64 bits
// hint: the counts were multiplied as 64-bit integers
namespace mc::merge_multiplies_whole_counts {
Moments merge(const Moments& a, const Moments& b) {
  if (a.count == 0) return b;
  if (b.count == 0) return a;
  const std::uint64_t count = a.count + b.count;
  const auto n = static_cast<double>(count);
  const double apart = b.mean - a.mean;
  return {count, a.mean + apart * (static_cast<double>(b.count) / n),
          a.m2 + b.m2 + apart * apart * static_cast<double>(a.count * b.count) / n};
}
}  // namespace mc::merge_multiplies_whole_counts

// mistake: divides by n even if both parts are empty
// hint: a part without values changes nothing; its share of the count may be 0/0
namespace mc::merge_nothing_is_nan {
Moments merge(const Moments& a, const Moments& b) {
  const auto n_a = static_cast<double>(a.count);
  const auto n_b = static_cast<double>(b.count);
  const double apart = b.mean - a.mean;
  return {a.count + b.count, a.mean + apart * (n_b / (n_a + n_b)),
          a.m2 + b.m2 + apart * apart * (n_a / (n_a + n_b) * n_b)};
}
}  // namespace mc::merge_nothing_is_nan

// mistake: computes n_b / n as integers, which is 0
// hint: this is the first part's mean alone
namespace mc::merge_share_in_whole_numbers {
Moments merge(const Moments& a, const Moments& b) {
  Moments all = right_merge(a, b);
  if (all.count == 0) return all;
  all.mean = a.mean + (b.mean - a.mean) * static_cast<double>(b.count / all.count);
  return all;
}
}  // namespace mc::merge_share_in_whole_numbers

// mistake: adds both m2 but not the variation between the two parts
// hint: parts with different means vary between each other
namespace mc::merge_without_between {
Moments merge(const Moments& a, const Moments& b) {
  Moments all = right_merge(a, b);
  all.m2 = a.m2 + b.m2;
  return all;
}
}  // namespace mc::merge_without_between

// mistake: keeps the last result in a static variable, for parts with the same counts
// hint: a static or global variable keeps its value between calls
namespace mc::merge_remembers_counts {
Moments merge(const Moments& a, const Moments& b) {
  static Moments last_a, last;
  if (last.count == a.count + b.count && last_a.count == a.count) return last;
  last_a = a;
  return last = right_merge(a, b);
}
}  // namespace mc::merge_remembers_counts

// mistake: takes counts that differ by less than 1 % for equal
// hint: weight the means by the counts
namespace mc::nearly_equal_counts {
Moments merge(const Moments& a, const Moments& b) {
  Moments all = right_merge(a, b);
  const auto n_a = static_cast<double>(a.count), n_b = static_cast<double>(b.count);
  if (std::abs(n_a - n_b) < 0.01 * n_a) all.mean = a.mean / 2 + b.mean / 2;
  return all;
}
}  // namespace mc::nearly_equal_counts

// mistake: takes a part with an m2 of 0 for empty, though it may have one value
// hint: one part was left out
namespace mc::merge_drops_single_values {
Moments merge(const Moments& a, const Moments& b) {
  return a.m2 == 0 ? b : b.m2 == 0 ? a : right_merge(a, b);
}
}  // namespace mc::merge_drops_single_values

// mistake: subtracts the means, which overflows for large ones
// hint: mean_b - mean_a, mean_a + mean_b
namespace mc::merge_distance_overflows {
Moments merge(const Moments& a, const Moments& b) {
  Moments all = right_merge(a, b);
  const double share = static_cast<double>(b.count) / static_cast<double>(all.count);
  if (all.count > 0) all.mean = a.mean + (b.mean - a.mean) * share;
  return all;
}
}  // namespace mc::merge_distance_overflows

// mistake: takes (a + b) / 2 as the mean of parts of equal size, whose sum may overflow
// hint: mean_a + mean_b
namespace mc::merge_halves {
Moments merge(const Moments& a, const Moments& b) {
  Moments all = right_merge(a, b);
  if (a.count == b.count && a.count > 0) all.mean = (a.mean + b.mean) / 2;
  return all;
}
}  // namespace mc::merge_halves
