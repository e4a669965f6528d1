// Mistakes in task 1.4.
#include "variance.hpp"

#define variance right_variance
#define add right_add
#include "solutions/variance.cpp"
#undef variance
#undef add

namespace mc {
namespace {

/// Welford's update, with this step of the mean.
void move_mean(Moments& moments, double x, double step) {
  const double before = x - moments.mean;
  moments.mean += step;
  moments.m2 += before * (x - moments.mean);
}

template <class Count>
void add_counting_in(Moments& moments, double x) {
  const auto count = static_cast<Count>(moments.count + 1);
  moments.count = static_cast<std::uint64_t>(count);
  move_mean(moments, x, (x - moments.mean) / static_cast<double>(count));
}

}  // namespace
}  // namespace mc

// mistake: converts the count to an int
// hint: keep the count an unsigned 64-bit integer
namespace mc::variance_counts_in_int {
double variance(const Moments& moments) {
  const int count = static_cast<int>(moments.count);
  return count >= 0 && count < 2 ? nan : moments.m2 / (count - 1);
}
}  // namespace mc::variance_counts_in_int

// mistake: counts in an unsigned int, which wraps to 0 at 2^32
// hint: 32 bits count only to 2^32
namespace mc::welford_counts_in_32_bits {
void add(Moments& moments, double x) {
  add_counting_in<unsigned>(moments, x);
}
}  // namespace mc::welford_counts_in_32_bits

// mistake: counts in a double, which adding 1 does not change from 2^53 on
// hint: a double counts only to 2^53
namespace mc::welford_counts_in_double {
void add(Moments& moments, double x) {
  add_counting_in<double>(moments, x);
}
}  // namespace mc::welford_counts_in_double

// mistake: counts in a float, which adding 1 does not change from 2^24 on
// hint: a float counts only to 2^24
namespace mc::welford_counts_in_float {
void add(Moments& moments, double x) {
  add_counting_in<float>(moments, x);
}
}  // namespace mc::welford_counts_in_float

// mistake: counts in an int, which is negative from 2^31 on
// hint: an int counts only to 2^31
namespace mc::welford_counts_in_int {
void add(Moments& moments, double x) {
  add_counting_in<int>(moments, x);
}
}  // namespace mc::welford_counts_in_int

// mistake: counts in a signed integer, which is negative from 2^63 on
// hint: keep the count an unsigned 64-bit integer
namespace mc::welford_counts_in_signed {
void add(Moments& moments, double x) {
  add_counting_in<std::int64_t>(moments, x);
}
}  // namespace mc::welford_counts_in_signed

// mistake: divides by the count before this value
// hint: the first value was divided by a count of 0: increment the count first
namespace mc::welford_counts_late {
void add(Moments& moments, double x) {
  move_mean(moments, x, (x - moments.mean) / static_cast<double>(moments.count++));
}
}  // namespace mc::welford_counts_late

// mistake: keeps the sum of squares and subtracts the mean, which is the textbook formula
// hint: not the sum of x^2
namespace mc::welford_keeps_squares {
void add(Moments& moments, double x) {
  const auto before = static_cast<double>(moments.count++);
  const auto count = static_cast<double>(moments.count);
  const double squares = moments.m2 + before * moments.mean * moments.mean + x * x;
  moments.mean += (x - moments.mean) / count;
  moments.m2 = squares - count * moments.mean * moments.mean;
}
}  // namespace mc::welford_keeps_squares

// mistake: keeps n times the sample variance in m2
// hint: this is n times the sample variance
namespace mc::welford_m2_is_n_variances {
void add(Moments& moments, double x) {
  const auto before = static_cast<double>(moments.count);
  if (before > 0) moments.m2 *= (before - 1) / before;
  right_add(moments, x);
  const auto count = static_cast<double>(moments.count);
  if (count > 1) moments.m2 *= count / (count - 1);
}

double variance(const Moments& moments) {
  return moments.count < 2 ? nan : moments.m2 / static_cast<double>(moments.count);
}
}  // namespace mc::welford_m2_is_n_variances

// mistake: updates the mean by a step that is rounded to a float
// hint: use double everywhere
namespace mc::welford_mean_in_float {
void add(Moments& moments, double x) {
  const auto before = static_cast<float>(x - moments.mean);
  move_mean(moments, x, before / static_cast<float>(++moments.count));
}
}  // namespace mc::welford_mean_in_float

// mistake: squares the distance from the new mean, (x - new mean)^2
// hint: here the new mean is used twice
namespace mc::welford_new_mean {
void add(Moments& moments, double x) {
  ++moments.count;
  moments.mean += (x - moments.mean) / static_cast<double>(moments.count);
  const double after = x - moments.mean;
  moments.m2 += after * after;
}
}  // namespace mc::welford_new_mean

// mistake: squares the distance from the old mean, (x - old mean)^2
// hint: here the old mean is used twice
namespace mc::welford_old_mean {
void add(Moments& moments, double x) {
  ++moments.count;
  const double before = x - moments.mean;
  moments.mean += before / static_cast<double>(moments.count);
  moments.m2 += before * before;
}
}  // namespace mc::welford_old_mean

// mistake: divides m2 by n instead of n - 1
// hint: this divides by n; a sample variance divides by n - 1
namespace mc::welford_over_n {
double variance(const Moments& moments) {
  return moments.count < 2 ? nan : moments.m2 / static_cast<double>(moments.count);
}
}  // namespace mc::welford_over_n

// mistake: computes 1 / count as integers, which is 0 from the second value on
// hint: an integer division, which gives 0
namespace mc::welford_whole_division {
void add(Moments& moments, double x) {
  move_mean(moments, x, (x - moments.mean) * static_cast<double>(1 / ++moments.count));
}
}  // namespace mc::welford_whole_division

// mistake: takes a mean of 0 for no values yet
// hint: a mean of 0 was taken for no values yet
namespace mc::mean_of_zero_is_empty {
void add(Moments& moments, double x) {
  const auto count = static_cast<double>(++moments.count);
  move_mean(moments, x, moments.mean == 0 ? x : (x - moments.mean) / count);
}
}  // namespace mc::mean_of_zero_is_empty

// mistake: the variance of one value is 0
// hint: a sample variance needs two values
namespace mc::variance_of_one_is_zero {
double variance(const Moments& moments) {
  return moments.count < 2 ? 0 : right_variance(moments);
}
}  // namespace mc::variance_of_one_is_zero
