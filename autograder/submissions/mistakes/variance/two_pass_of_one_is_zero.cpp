// mistake: calls the variance of one value 0
// caught by: 1.3 fewer than two values
// hint: quiet_NaN() for what is undefined
#include "variance.hpp"
#define variance_two_pass right_variance_two_pass
#include "solutions/variance.cpp"
#undef variance_two_pass

namespace mc {

double variance_two_pass(std::span<const double> x) {
  return x.size() < 2 ? 0 : right_variance_two_pass(x);
}

}  // namespace mc
