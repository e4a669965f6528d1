// mistake: the sum is a float
// caught by: 5.1 the radical inverse mirrors
// caught by: 5.1 every index
// caught by: 5.1 the last digit
// caught by: 5.1 the radical inverse is below 1
// hint: this is a float
#include "halton.hpp"

#define radical_inverse right_radical_inverse
#include "solutions/halton.cpp"
#undef radical_inverse

namespace mc {

double radical_inverse(unsigned base, std::uint64_t index) {
  require_base(base);
  float sum = 0, part = 1;
  for (; index > 0; index /= base) {
    part /= static_cast<float>(base);
    sum += part * static_cast<float>(index % base);
  }
  return sum;
}

}  // namespace mc
