// mistake: divides n_a n_b by n as whole numbers
// caught by: 1.5 merging two parts
// caught by: 1.5 parts of real data
// caught by: 1.5 merging very unequal
// hint: n_a n_b / n was divided as whole numbers
#include "variance.hpp"
#define merge right_merge
#include "solutions/variance.cpp"
#undef merge

namespace mc {

Moments merge(const Moments& a, const Moments& b) {
  Moments all = right_merge(a, b);
  if (a.count == 0 || b.count == 0) return all;
  const double apart = b.mean - a.mean;
  all.m2 = a.m2 + b.m2 + apart * apart * static_cast<double>(a.count * b.count / all.count);
  return all;
}

}  // namespace mc
