// mistake: keeps n times the sample variance in m2
// caught by: 1.4 add keeps
// caught by: 1.4 the variance of moments
// caught by: 1.4 Welford keeps
// caught by: 1.4 Welford on constant
// hint: this is n times the sample variance
#include "variance.hpp"
#define add right_add
#define variance right_variance
#include "solutions/variance.cpp"
#undef add
#undef variance

namespace mc {

void add(Moments& moments, double x) {
  const auto before = static_cast<double>(moments.count);
  if (before > 0) moments.m2 *= (before - 1) / before;
  right_add(moments, x);
  const auto count = static_cast<double>(moments.count);
  if (count > 1) moments.m2 *= count / (count - 1);
}

double variance(const Moments& moments) {
  return moments.count < 2 ? nan : moments.m2 / static_cast<double>(moments.count);
}

}  // namespace mc
