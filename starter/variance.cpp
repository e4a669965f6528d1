// Lab 1 · variance. labs/1-variance/variance.hpp states what each function promises, and
// labs/1-variance/README.md is the handout. Write the tasks in any order and check them with
//
//   ./lab check variance              the whole lab
//   ./lab check variance --only 1.1   one task

#include "variance.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "common/todo.hpp"

namespace mc {

/// A finished example: the largest value minus the smallest; NaN for no values.
[[maybe_unused]] static double range(std::span<const double> x) {
  if (x.empty()) return std::numeric_limits<double>::quiet_NaN();
  double low = x[0], high = x[0];
  for (const double value : x) {
    if (std::isnan(value)) return value;  // min and max would skip it: its comparisons are false
    low = std::min(low, value);
    high = std::max(high, value);
  }
  return high - low;  // infinite if the difference is too large for a double
}

double mean(std::span<const double> x) {
  throw todo("1.1");  // TODO(1.1): the mean; the sum may overflow although the mean does not
}

double variance_textbook(std::span<const double> x) {
  throw todo("1.2");  // TODO(1.2): E{X^2} - E{X}^2, times n / (n - 1)
}

double variance_two_pass(std::span<const double> x) {
  throw todo("1.3");  // TODO(1.3): the mean, then the squared deviations, then the correction
}

void add(Moments& moments, double x) {
  throw todo("1.4");  // TODO(1.4): Welford's update
}

double variance(const Moments& moments) {
  throw todo("1.4");  // TODO(1.4): the sample variance from count, mean and m2
}

Moments merge(const Moments& a, const Moments& b) {
  throw todo("1.5");  // TODO(1.5): how much does the difference of the two means add to m2?
}

double covariance(std::span<const double> x, std::span<const double> y) {
  throw todo("1.6");  // TODO(1.6): the sum of the products of deviations, over n - 1
}

double dependence(std::span<const double> joint, std::size_t columns) {
  throw todo("1.7");  // TODO(1.7): normalize, sum rows and columns, compare p(x,y) to p(x) p(y)
}

Moments moments(std::span<const double> x) {
  throw todo("1.8");  // TODO(1.8): stretch, the speed task; a loop over add() is slow
}

}  // namespace mc
