// mistake: std::accumulate begins with 0, an int, and adds in int
// caught by: 1.1 the mean of a list
// caught by: 1.1 the mean is finite
// caught by: 1.1 the mean hides no infinity
// hint: the sum is cut off to a whole number
#include <numeric>
#include "variance.hpp"
#define mean(x) right_mean(x)
#include "solutions/variance.cpp"
#undef mean

namespace mc {

double mean(std::span<const double> x) {
  return std::accumulate(x.begin(), x.end(), 0) / static_cast<double>(x.size());
}

}  // namespace mc
