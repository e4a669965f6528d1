// mistake: measures both parts from their common mean, after that was rounded
// caught by: 1.5 merging very unequal and very long parts
// hint: both parts were measured from the merged mean, which is rounded
#include "variance.hpp"
#define merge right_merge
#include "solutions/variance.cpp"
#undef merge

namespace mc {

Moments merge(const Moments& a, const Moments& b) {
  Moments all = right_merge(a, b);
  const double from_a = a.mean - all.mean;
  const double from_b = b.mean - all.mean;
  all.m2 = a.m2 + static_cast<double>(a.count) * from_a * from_a +  //
           b.m2 + static_cast<double>(b.count) * from_b * from_b;
  return all;
}

}  // namespace mc
