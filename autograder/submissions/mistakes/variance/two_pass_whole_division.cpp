// mistake: n / (n - 1) of whole numbers, which is 1 from n = 3 on
// caught by: 1.3 the two-pass variance of tame
// caught by: 1.3 two passes keep
// caught by: 1.3 two passes on hard
// hint: n/(n-1) of whole numbers is 1
#include "variance.hpp"
#define variance_two_pass right_variance_two_pass
#include "solutions/variance.cpp"
#undef variance_two_pass

namespace mc {

double variance_two_pass(std::span<const double> x) {
  const std::size_t n = x.size();
  if (n < 2) return nan;
  const double centre = mean(x);
  double m2 = 0, off = 0;
  for (double value : x) {
    m2 += (value - centre) * (value - centre);
    off += value - centre;
  }
  m2 -= off * off / static_cast<double>(n);
  return std::max(m2, 0.0) / static_cast<double>(n) * static_cast<double>(n / (n - 1));
}

}  // namespace mc
