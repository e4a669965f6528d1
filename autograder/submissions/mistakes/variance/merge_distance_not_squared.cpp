// mistake: adds the distance of the two means, not its square
// caught by: 1.5 merging two parts
// caught by: 1.5 parts of real data
// caught by: 1.5 merging very unequal
// hint: the distance of the means is squared
#include "variance.hpp"
#define merge right_merge
#include "solutions/variance.cpp"
#undef merge

namespace mc {

Moments merge(const Moments& a, const Moments& b) {
  Moments all = right_merge(a, b);
  if (a.count == 0 || b.count == 0) return all;
  const auto n_a = static_cast<double>(a.count), n_b = static_cast<double>(b.count);
  all.m2 = a.m2 + b.m2 + std::abs(b.mean - a.mean) * (n_a / (n_a + n_b) * n_b);
  return all;
}

}  // namespace mc
