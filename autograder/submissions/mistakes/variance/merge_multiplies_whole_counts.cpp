// mistake: multiplies the counts as whole numbers, beyond 64 bits
// caught by: 1.5 merging very unequal and very long parts
// hint: the counts were multiplied as 64-bit whole numbers
#include "variance.hpp"
#define merge right_merge
#include "solutions/variance.cpp"
#undef merge

namespace mc {

Moments merge(const Moments& a, const Moments& b) {
  if (a.count == 0) return b;
  if (b.count == 0) return a;
  const std::uint64_t count = a.count + b.count;
  const auto n = static_cast<double>(count);
  const double apart = b.mean - a.mean;
  return {count, a.mean + apart * (static_cast<double>(b.count) / n),
          a.m2 + b.m2 + apart * apart * static_cast<double>(a.count * b.count) / n};
}

}  // namespace mc
