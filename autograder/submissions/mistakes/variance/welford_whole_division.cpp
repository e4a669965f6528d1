// mistake: 1 / count of whole numbers, which is 0 from the second value on
// caught by: 1.4 add keeps
// caught by: 1.4 Welford keeps
// caught by: 1.4 Welford on constant
// caught by: 1.4 Welford survives
// caught by: 1.4 one more value
// hint: an integer division, which is 0
#include "variance.hpp"
#define add right_add
#include "solutions/variance.cpp"
#undef add

namespace mc {

void add(Moments& moments, double x) {
  ++moments.count;
  const double before = x - moments.mean;
  moments.mean += before * static_cast<double>(1 / moments.count);
  moments.m2 += before * (x - moments.mean);
}

}  // namespace mc
