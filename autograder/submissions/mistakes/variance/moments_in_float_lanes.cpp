// mistake: sums in float lanes, twice as many to a register
// caught by: 1.8 the moments of a list of any length
// caught by: 1.8 the moments keep their digits on hard data
// caught by: 1.8 the moments keep their digits beside outliers
// hint: Is any sum a float?
#include "variance.hpp"
#define moments right_moments
#include "solutions/variance.cpp"
#undef moments

namespace mc {

Moments moments(std::span<const double> x) {
  if (x.empty()) return {};
  float sum = 0, m2 = 0;
  for (double value : x) sum += static_cast<float>(value - x[0]);
  const float offset = sum / static_cast<float>(x.size());
  for (double value : x) {
    const float deviation = static_cast<float>(value - x[0]) - offset;
    m2 += deviation * deviation;
  }
  return {x.size(), x[0] + offset, m2};
}

}  // namespace mc
