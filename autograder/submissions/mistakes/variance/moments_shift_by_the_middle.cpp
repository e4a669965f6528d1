// mistake: one pass about the value in the middle, which may be far from all others
// caught by: 1.8 the moments keep their digits beside outliers
// hint: is everything measured from a value that may lie far
#include "variance.hpp"
#define moments right_moments
#include "solutions/variance.cpp"
#undef moments

namespace mc {

Moments moments(std::span<const double> x) {
  if (x.empty()) return {};
  const auto n = static_cast<double>(x.size());
  const double shift = x[x.size() / 2];
  double sum = 0;
  double sum_of_squares = 0;
  for (double value : x) {
    sum += value - shift;
    sum_of_squares += (value - shift) * (value - shift);
  }
  return {x.size(), shift + sum / n, sum_of_squares - sum * sum / n};
}

}  // namespace mc
