// mistake: calls the mean of nothing 0
// caught by: 1.1 the mean of nothing
// hint: quiet_NaN() for what is undefined
#include "variance.hpp"
#define mean(x) right_mean(x)
#include "solutions/variance.cpp"
#undef mean

namespace mc {

double mean(std::span<const double> x) {
  return x.empty() ? 0 : right_mean(x);
}

}  // namespace mc
