// mistake: adds the counts as doubles, which round them beyond 2^53
// caught by: 1.5 merging very unequal
// hint: the counts add up, as whole numbers of 64 bits
#include "variance.hpp"
#define merge right_merge
#include "solutions/variance.cpp"
#undef merge

namespace mc {

Moments merge(const Moments& a, const Moments& b) {
  Moments all = right_merge(a, b);
  all.count =
      static_cast<std::uint64_t>(static_cast<double>(a.count) + static_cast<double>(b.count));
  return all;
}

}  // namespace mc
