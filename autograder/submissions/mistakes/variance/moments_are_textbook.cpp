// mistake: the textbook formula, because one pass is fast
// caught by: 1.8 the moments keep their digits on hard data
// hint: these are the digits that E{X^2} - E{X}^2 gives
#include "variance.hpp"
#define moments right_moments
#include "solutions/variance.cpp"
#undef moments

namespace mc {

Moments moments(std::span<const double> x) {
  if (x.empty()) return {};
  const auto n = static_cast<double>(x.size());
  double sum = 0;
  double sum_of_squares = 0;
  for (double value : x) {
    sum += value;
    sum_of_squares += value * value;
  }
  return {x.size(), sum / n, sum_of_squares - sum * sum / n};
}

}  // namespace mc
