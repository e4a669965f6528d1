// mistake: adds everything up first, in a sum that overflows where the mean does not
// caught by: 1.1 the mean is finite
// hint: the sum overflows where the mean does not
#include "variance.hpp"
#define mean(x) right_mean(x)
#include "solutions/variance.cpp"
#undef mean

namespace mc {

double mean(std::span<const double> x) {
  double sum = 0;
  for (double value : x) sum += value;
  return sum / static_cast<double>(x.size());
}

}  // namespace mc
