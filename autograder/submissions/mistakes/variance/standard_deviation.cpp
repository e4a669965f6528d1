// mistake: the standard deviation where the variance is asked for
// caught by: 1.3 the variance of constant data is zero
// caught by: 1.3 the two-pass variance of tame data
// caught by: 1.3 two passes keep their digits under a large mean
// caught by: 1.3 two passes on hard cases
// caught by: 1.3 sigma of aX
// hint: this is the standard deviation
#include "variance.hpp"
#define variance_two_pass right_variance_two_pass
#include "solutions/variance.cpp"
#undef variance_two_pass

namespace mc {

double variance_two_pass(std::span<const double> x) {
  return std::sqrt(right_variance_two_pass(x));
}

}  // namespace mc
