// mistake: takes the count for an int
// caught by: 1.4 the variance of moments
// caught by: 1.4 one more value
// hint: is the count a whole number of 64 bits all the way?
#include "variance.hpp"
#define variance right_variance
#include "solutions/variance.cpp"
#undef variance

namespace mc {

double variance(const Moments& moments) {
  const int count = static_cast<int>(moments.count);
  return count >= 0 && count < 2 ? nan : moments.m2 / (count - 1);
}

}  // namespace mc
