// mistake: gives mean and m2, and a count of 0
// caught by: 1.8 the moments of a list of any length
// caught by: 1.8 the moments keep their digits on hard data
// caught by: 1.8 the moments keep their digits beside outliers
// hint: count is never set
#include "variance.hpp"
#define moments right_moments
#include "solutions/variance.cpp"
#undef moments

namespace mc {

Moments moments(std::span<const double> x) {
  const Moments all = right_moments(x);
  return {0, all.mean, all.m2};
}

}  // namespace mc
