// mistake: adds the two m2 up and leaves out what the parts vary between them
// caught by: 1.5 merging two parts equals adding all values
// caught by: 1.5 parts of real data merge to the whole
// caught by: 1.5 merging very unequal and very long parts
// hint: two parts with different means vary between them too
#include "variance.hpp"
#define merge right_merge
#include "solutions/variance.cpp"
#undef merge

namespace mc {

Moments merge(const Moments& a, const Moments& b) {
  Moments all = right_merge(a, b);
  all.m2 = a.m2 + b.m2;
  return all;
}

}  // namespace mc
