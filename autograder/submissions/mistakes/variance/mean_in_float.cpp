// mistake: adds the values up in a float
// caught by: 1.1 the mean of a list of values
// caught by: 1.1 the mean is finite
// hint: a float keeps seven digits
// hint: a float ends at 3.4e38
#include "variance.hpp"
#define mean(x) right_mean(x)
#include "solutions/variance.cpp"
#undef mean

namespace mc {

double mean(std::span<const double> x) {
  float sum = 0;
  for (double value : x) sum += static_cast<float>(value);
  return sum / static_cast<float>(x.size());
}

}  // namespace mc
