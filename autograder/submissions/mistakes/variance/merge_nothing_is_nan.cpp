// mistake: divides by n also where both parts are empty
// caught by: 1.5 merging with an empty part changes nothing
// caught by: 1.5 parts of real data merge to the whole
// hint: 0/0 is NaN: look for an empty part first
#include "variance.hpp"
#define merge right_merge
#include "solutions/variance.cpp"
#undef merge

namespace mc {

Moments merge(const Moments& a, const Moments& b) {
  const auto n_a = static_cast<double>(a.count);
  const auto n_b = static_cast<double>(b.count);
  const double apart = b.mean - a.mean;
  return {a.count + b.count, a.mean + apart * (n_b / (n_a + n_b)),
          a.m2 + b.m2 + apart * apart * (n_a / (n_a + n_b) * n_b)};
}

}  // namespace mc
