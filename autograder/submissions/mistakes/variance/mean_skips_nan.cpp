// mistake: leaves NaN and infinities out, as if they were not there
// caught by: 1.1 the mean hides no infinity
// hint: is infinite or NaN
#include "variance.hpp"
#define mean(x) right_mean(x)
#include "solutions/variance.cpp"
#undef mean

namespace mc {

double mean(std::span<const double> x) {
  std::vector<double> numbers;
  std::copy_if(x.begin(), x.end(), std::back_inserter(numbers),
               [](double value) { return std::isfinite(value); });
  return right_mean(numbers);
}

}  // namespace mc
