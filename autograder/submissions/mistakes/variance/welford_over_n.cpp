// mistake: divides m2 by n where a sample variance divides by n - 1
// caught by: 1.4 the variance of moments
// hint: this divides by n; a sample variance divides by n - 1
#include "variance.hpp"
#define variance right_variance
#include "solutions/variance.cpp"
#undef variance

namespace mc {

double variance(const Moments& moments) {
  return moments.count < 2 ? nan : moments.m2 / static_cast<double>(moments.count);
}

}  // namespace mc
