// mistake: divides by the count also where it is 0
// caught by: 1.8 the moments of no values
// hint: nothing to add, nothing to divide by
#include "variance.hpp"
#define moments right_moments
#include "solutions/variance.cpp"
#undef moments

namespace mc {

Moments moments(std::span<const double> x) {
  return x.empty() ? Moments{0, nan, nan} : right_moments(x);
}

}  // namespace mc
