// mistake: one pass where two are asked for: the mean is rounded at every value
// caught by: 1.3 two passes keep their digits under a large mean
// hint: these are the digits of a running mean
#include "variance.hpp"
#define variance_two_pass right_variance_two_pass
#include "solutions/variance.cpp"
#undef variance_two_pass

namespace mc {

double variance_two_pass(std::span<const double> x) {
  Moments all;
  for (double value : x) add(all, value);
  return variance(all);
}

}  // namespace mc
