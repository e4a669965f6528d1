// mistake: the digits stand behind the point in the order in which the index has them
// caught by: 5.1 the radical inverse mirrors
// caught by: 5.1 every index
// caught by: 5.1 the last digit
// hint: the digits are not mirrored
#include "halton.hpp"

#define radical_inverse right_radical_inverse
#include "solutions/halton.cpp"
#undef radical_inverse

namespace mc {

double radical_inverse(unsigned base, std::uint64_t index) {
  require_base(base);
  double size = 1;
  for (std::uint64_t rest = index; rest > 0; rest /= base) size *= base;
  return std::min(below_one, static_cast<double>(index) / size);
}

}  // namespace mc
