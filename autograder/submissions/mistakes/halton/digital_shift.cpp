// mistake: one flip for each level of bits, not for each string of bits before
// caught by: 5.8 each bit
// caught by: 5.8 a scrambled net
// hint: that is a digital shift
#include "halton.hpp"

#define owen_scramble right_owen_scramble
#include "solutions/halton.cpp"
#undef owen_scramble

namespace mc {

void owen_scramble(std::span<double> column, std::uint64_t seed) {
  const std::uint64_t flips = Rng(seed)() >> 11;
  for (double& value : column) {
    const auto word = static_cast<std::uint64_t>(value * 0x1p53);
    value = static_cast<double>(word ^ flips) * 0x1p-53;
  }
}

}  // namespace mc
