// mistake: divides the sum by n - 1, as the variance does
// caught by: 1.1 the mean of a list of values
// caught by: 1.1 the mean is finite
// hint: this divides by n - 1; only the variance does
#include "variance.hpp"
#define mean(x) right_mean(x)
#include "solutions/variance.cpp"
#undef mean

namespace mc {

double mean(std::span<const double> x) {
  if (x.empty()) return nan;
  const auto n = static_cast<double>(x.size());
  double sum = 0;
  for (double value : x) sum += value / (n - 1);
  return sum;
}

}  // namespace mc
