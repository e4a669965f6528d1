// mistake: the textbook formula under another name
// caught by: 1.3 two passes keep their digits under a large mean
// caught by: 1.3 the variance of constant data is zero
// caught by: 1.3 two passes on hard cases
// hint: these are the digits that E{X^2} - E{X}^2 gives
#include "variance.hpp"
#define variance_two_pass right_variance_two_pass
#include "solutions/variance.cpp"
#undef variance_two_pass

namespace mc {

double variance_two_pass(std::span<const double> x) {
  return variance_textbook(x);
}

}  // namespace mc
