// mistake: the share n_b / n of whole numbers, which is 0
// caught by: 1.5 merging two parts
// caught by: 1.5 parts of real data
// caught by: 1.5 merging very unequal
// hint: this is the first part's mean alone
#include "variance.hpp"
#define merge right_merge
#include "solutions/variance.cpp"
#undef merge

namespace mc {

Moments merge(const Moments& a, const Moments& b) {
  Moments all = right_merge(a, b);
  if (all.count == 0) return all;
  all.mean = a.mean + (b.mean - a.mean) * static_cast<double>(b.count / all.count);
  return all;
}

}  // namespace mc
