// mistake: takes the mean of the two means, whatever the counts
// caught by: 1.5 merging two parts equals adding all values
// caught by: 1.5 parts of real data merge to the whole
// caught by: 1.5 merging very unequal and very long parts
// hint: the mean of two means is right only for equal counts
#include "variance.hpp"
#define merge right_merge
#include "solutions/variance.cpp"
#undef merge

namespace mc {

Moments merge(const Moments& a, const Moments& b) {
  Moments all = right_merge(a, b);
  if (a.count > 0 && b.count > 0) all.mean = (a.mean + b.mean) / 2;
  return all;
}

}  // namespace mc
