// mistake: looks for an infinite sum above zero only
// caught by: 1.1 the mean is finite
// hint: a sum can overflow to -inf as well
#include "variance.hpp"
#define mean(x) right_mean(x)
#include "solutions/variance.cpp"
#undef mean

namespace mc {

double mean(std::span<const double> x) {
  double sum = 0;
  for (double value : x) sum += value;
  return sum == std::numeric_limits<double>::infinity() ? right_mean(x)
                                                        : sum / static_cast<double>(x.size());
}

}  // namespace mc
