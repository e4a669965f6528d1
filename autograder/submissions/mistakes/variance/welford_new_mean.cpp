// mistake: squares the distance from the new mean, (x - new mean)^2
// caught by: 1.4 add keeps count and mean and m2
// caught by: 1.4 Welford keeps his digits
// caught by: 1.4 Welford on constant data
// caught by: 1.4 Welford survives a stream
// hint: this is the new one, twice
#include "variance.hpp"
#define add right_add
#include "solutions/variance.cpp"
#undef add

namespace mc {

void add(Moments& moments, double x) {
  ++moments.count;
  moments.mean += (x - moments.mean) / static_cast<double>(moments.count);
  const double after = x - moments.mean;
  moments.m2 += after * after;
}

}  // namespace mc
