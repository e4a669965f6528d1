// mistake: counts in an int, which is negative from 2^31 on
// caught by: 1.4 one more value after very many
// hint: an int counts to 2^31 only
#include "variance.hpp"
#define add right_add
#include "solutions/variance.cpp"
#undef add

namespace mc {

void add(Moments& moments, double x) {
  const int count = static_cast<int>(++moments.count);
  const double before = x - moments.mean;
  moments.mean += before / count;
  moments.m2 += before * (x - moments.mean);
}

}  // namespace mc
