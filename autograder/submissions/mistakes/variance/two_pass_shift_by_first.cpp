// mistake: one pass about the first value, which may be far from all others
// caught by: 1.3 two passes on hard cases
// hint: is everything measured from a value that may lie far
#include "variance.hpp"
#define variance_two_pass right_variance_two_pass
#include "solutions/variance.cpp"
#undef variance_two_pass

namespace mc {

double variance_two_pass(std::span<const double> x) {
  if (x.size() < 2) return nan;
  const auto n = static_cast<double>(x.size());
  double sum = 0, squares = 0;
  for (double value : x) {
    const double d = value - x.front();
    sum += d;
    squares += d * d;
  }
  return std::max(squares - sum * sum / n, 0.0) / (n - 1);
}

}  // namespace mc
