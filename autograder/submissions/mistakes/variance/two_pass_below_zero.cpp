// mistake: lets the correction take the variance of constant data below zero
// caught by: 1.3 the variance of constant data is zero
// hint: the correction is rounded, and may be larger than the sum: return 0 then
#include "variance.hpp"
#define variance_two_pass right_variance_two_pass
#include "solutions/variance.cpp"
#undef variance_two_pass

namespace mc {

double variance_two_pass(std::span<const double> x) {
  if (x.size() < 2) return nan;
  const auto n = static_cast<double>(x.size());
  const double centre = mean(x);
  double m2 = 0;
  double correction = 0;
  for (double value : x) {
    m2 += (value - centre) * (value - centre);
    correction += value - centre;
  }
  return (m2 - correction * correction / n) / (n - 1);
}

}  // namespace mc
