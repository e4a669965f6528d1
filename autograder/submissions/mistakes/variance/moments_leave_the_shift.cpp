// mistake: shifts the data and leaves the mean where it was shifted to
// caught by: 1.8 the moments of a list of any length
// caught by: 1.8 the moments keep their digits on hard data
// caught by: 1.8 the moments keep their digits beside outliers
// hint: was the shift put back
#include "variance.hpp"
#define moments right_moments
#include "solutions/variance.cpp"
#undef moments

namespace mc {

Moments moments(std::span<const double> x) {
  Moments all = right_moments(x);
  if (!x.empty()) all.mean -= shift_near(x);
  return all;
}

}  // namespace mc
