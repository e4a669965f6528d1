// mistake: squares the distance from the old mean, (x - old mean)^2
// caught by: 1.4 add keeps count and mean and m2
// caught by: 1.4 Welford keeps his digits
// caught by: 1.4 Welford on constant data
// caught by: 1.4 Welford survives a stream
// hint: this is the old one, twice
#include "variance.hpp"
#define add right_add
#include "solutions/variance.cpp"
#undef add

namespace mc {

void add(Moments& moments, double x) {
  ++moments.count;
  const double before = x - moments.mean;
  moments.mean += before / static_cast<double>(moments.count);
  moments.m2 += before * before;
}

}  // namespace mc
