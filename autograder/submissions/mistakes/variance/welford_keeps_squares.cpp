// mistake: keeps the sum of squares and takes the mean off it, which is the textbook formula
// caught by: 1.4 Welford keeps his digits
// caught by: 1.4 Welford on constant data
// hint: not the sum of x^2
#include "variance.hpp"
#define add right_add
#include "solutions/variance.cpp"
#undef add

namespace mc {

void add(Moments& moments, double x) {
  const auto before = static_cast<double>(moments.count++);
  const auto count = static_cast<double>(moments.count);
  const double squares = moments.m2 + before * moments.mean * moments.mean + x * x;
  moments.mean += (x - moments.mean) / count;
  moments.m2 = squares - count * moments.mean * moments.mean;
}

}  // namespace mc
