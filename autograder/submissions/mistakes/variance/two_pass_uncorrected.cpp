// mistake: takes the rounded mean for the mean: two passes without the correction
// caught by: 1.3 two passes keep their digits under a large mean
// caught by: 1.3 the variance of constant data is zero
// hint: the mean was rounded: take (sum of deviations)^2 / n off
#include "variance.hpp"
#define variance_two_pass right_variance_two_pass
#include "solutions/variance.cpp"
#undef variance_two_pass

namespace mc {

double variance_two_pass(std::span<const double> x) {
  if (x.size() < 2) return nan;
  const double centre = mean(x);
  double m2 = 0;
  for (double value : x) m2 += (value - centre) * (value - centre);
  return m2 / static_cast<double>(x.size() - 1);
}

}  // namespace mc
