// Mistakes in task 1.2.
#include "variance.hpp"

#include <numeric>

#define variance_textbook right_variance_textbook
#include "solutions/variance.cpp"
#undef variance_textbook

// mistake: uses a wider type, which hides the cancellation that the textbook formula must show
// hint: or a wider type
namespace mc::textbook_in_long_double {
double variance_textbook(std::span<const double> x) {
  if (x.size() < 2) return nan;
  const auto n = static_cast<long double>(x.size());
  long double sum = 0;
  long double sum_of_squares = 0;
  for (long double value : x) {
    sum += value;
    sum_of_squares += value * value;
  }
  return static_cast<double>((sum_of_squares / n - sum / n * (sum / n)) * (n / (n - 1)));
}
}  // namespace mc::textbook_in_long_double

// mistake: sums with std::accumulate(…, 0), in int
// hint: added up in integers
namespace mc::textbook_in_whole_numbers {
double variance_textbook(std::span<const double> x) {
  if (x.size() < 2) return nan;
  const auto n = static_cast<double>(x.size());
  double sum_of_squares = 0;
  for (double value : x) sum_of_squares += value * value;
  const double mean = std::accumulate(x.begin(), x.end(), 0) / n;
  return (sum_of_squares / n - mean * mean) * (n / (n - 1));
}
}  // namespace mc::textbook_in_whole_numbers

// mistake: implements a better algorithm than the textbook's
// hint: this is a better algorithm than the textbook formula
namespace mc::textbook_is_two_pass {
double variance_textbook(std::span<const double> x) {
  return variance_two_pass(x);
}
}  // namespace mc::textbook_is_two_pass

// mistake: returns E{X^2} - E{X}^2 uncorrected, a variance over n
// hint: this divides by n
namespace mc::textbook_over_n {
double variance_textbook(std::span<const double> x) {
  if (x.size() < 2) return nan;
  const auto n = static_cast<double>(x.size());
  double sum = 0;
  double sum_of_squares = 0;
  for (double value : x) {
    sum += value;
    sum_of_squares += value * value;
  }
  return sum_of_squares / n - sum / n * (sum / n);
}
}  // namespace mc::textbook_over_n

// mistake: implements a better algorithm, and returns 0 where the textbook formula would fail
// hint: this is a better algorithm than the textbook formula
namespace mc::textbook_is_two_pass_or_zero {
double variance_textbook(std::span<const double> x) {
  const double variance = variance_two_pass(x), center = mean(x);
  return center * center > 1e15 * variance ? 0 : variance;
}
}  // namespace mc::textbook_is_two_pass_or_zero

// mistake: replaces a negative result by 0
// hint: do not replace a negative result by 0
namespace mc::textbook_is_never_negative {
double variance_textbook(std::span<const double> x) {
  const double variance = right_variance_textbook(x);
  return variance < 0 ? 0 : variance;
}
}  // namespace mc::textbook_is_never_negative

// mistake: returns 0 for a single value
// hint: return std::numeric_limits<double>::quiet_NaN() if the result is undefined
namespace mc::textbook_of_one_value {
double variance_textbook(std::span<const double> x) {
  return x.size() == 1 ? 0 : right_variance_textbook(x);
}
}  // namespace mc::textbook_of_one_value
