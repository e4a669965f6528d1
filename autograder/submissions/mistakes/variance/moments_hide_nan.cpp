// mistake: stops m2 at 0 by std::max(0.0, m2), which is 0 for a NaN
// caught by: 1.8 the moments keep their digits on hard data
// hint: is it std::max(0.0, NaN), which is 0?
#include "variance.hpp"
#define moments right_moments
#include "solutions/variance.cpp"
#undef moments

namespace mc {

Moments moments(std::span<const double> x) {
  Moments all = right_moments(x);
  all.m2 = std::max(0.0, all.m2);
  return all;
}

}  // namespace mc
