// mistake: leaves the values out that do not fill a last block of 16
// caught by: 1.8 the moments of a list of any length
// caught by: 1.8 the moments keep their digits on hard data
// caught by: 1.8 the moments keep their digits beside outliers
// hint: also those in a last, shorter block
#include "variance.hpp"
#define moments right_moments
#include "solutions/variance.cpp"
#undef moments

namespace mc {

Moments moments(std::span<const double> x) {
  return right_moments(x.first(x.size() / 16 * 16));
}

}  // namespace mc
