// mistake: stops at 0 by std::max(0.0, m2), which is 0 for a NaN
// caught by: 1.3 two passes on hard cases
// hint: is it std::max(0.0, NaN), which is 0?
#include "variance.hpp"
#define variance_two_pass right_variance_two_pass
#include "solutions/variance.cpp"
#undef variance_two_pass

namespace mc {

double variance_two_pass(std::span<const double> x) {
  if (x.size() < 2) return nan;
  return std::max(0.0, right_variance_two_pass(x));
}

}  // namespace mc
