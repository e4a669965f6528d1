// mistake: one pass about the median of the first, the middle and the last value, all of which may be far from the others
// caught by: 1.8 the moments keep their digits beside outliers
// hint: far from all others
#include "variance.hpp"
#define moments right_moments
#include "solutions/variance.cpp"
#undef moments

namespace mc {

Moments moments(std::span<const double> x) {
  if (x.empty()) return {};
  const auto n = static_cast<double>(x.size());
  const double first = x.front(), middle = x[x.size() / 2], last = x.back();
  const double shift = std::max(std::min(first, middle), std::min(std::max(first, middle), last));
  double sum = 0;
  double sum_of_squares = 0;
  for (double value : x) {
    sum += value - shift;
    sum_of_squares += (value - shift) * (value - shift);
  }
  return {x.size(), shift + sum / n, std::max(sum_of_squares - sum * sum / n, 0.0)};
}

}  // namespace mc
