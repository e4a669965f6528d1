// mistake: moves the mean by a step that was rounded to a float
// caught by: 1.4 add keeps count and mean and m2
// caught by: 1.4 Welford keeps his digits
// caught by: 1.4 Welford on constant data
// hint: is anything here a float?
#include "variance.hpp"
#define add right_add
#include "solutions/variance.cpp"
#undef add

namespace mc {

void add(Moments& moments, double x) {
  ++moments.count;
  const double before = x - moments.mean;
  moments.mean += static_cast<float>(before) / static_cast<float>(moments.count);
  moments.m2 += before * (x - moments.mean);
}

}  // namespace mc
