// mistake: the mirrored digits overflow 32 bits
// caught by: 5.1 every index
// caught by: 5.1 the last digit
// hint: the mirrored digits do not fit in 32 bits
#include "halton.hpp"

#define radical_inverse right_radical_inverse
#include "solutions/halton.cpp"
#undef radical_inverse

namespace mc {

double radical_inverse(unsigned base, std::uint64_t index) {
  require_base(base);
  std::uint32_t mirrored = 0;
  double size = 1;
  for (; index > 0; index /= base, size *= base) {
    mirrored = mirrored * base + static_cast<std::uint32_t>(index % base);
  }
  return std::min(below_one, mirrored / size);
}

}  // namespace mc
