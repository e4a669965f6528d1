// mistake: divides by the count of the values before this one
// caught by: 1.4 add keeps count and mean and m2
// caught by: 1.4 Welford keeps his digits
// caught by: 1.4 Welford on constant data
// caught by: 1.4 Welford survives a stream
// hint: with the count that includes x
#include "variance.hpp"
#define add right_add
#include "solutions/variance.cpp"
#undef add

namespace mc {

void add(Moments& moments, double x) {
  const double before = x - moments.mean;
  moments.mean += before / static_cast<double>(moments.count);
  ++moments.count;
  moments.m2 += before * (x - moments.mean);
}

}  // namespace mc
