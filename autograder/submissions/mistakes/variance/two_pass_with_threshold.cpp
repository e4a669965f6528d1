// mistake: calls a variance below 1e-12 zero, whatever the scale of the data
// caught by: 1.3 two passes on hard cases
// caught by: 1.3 sigma of aX
// hint: small is not zero
// hint: the result depends on the scale of the data
#include "variance.hpp"
#define variance_two_pass right_variance_two_pass
#include "solutions/variance.cpp"
#undef variance_two_pass

namespace mc {

double variance_two_pass(std::span<const double> x) {
  const double variance = right_variance_two_pass(x);
  return variance < 1e-12 ? 0 : variance;
}

}  // namespace mc
