// mistake: flips are hashes of the bits before as a number: 0, 00 and 000 are the same
// caught by: 5.8 each bit
// caught by: 5.8 all 64 bits
// caught by: 5.8 a scrambled net
// hint: 0, 00 and 000 before a bit are different strings
#include "halton.hpp"

#define owen_scramble right_owen_scramble
#include "solutions/halton.cpp"
#undef owen_scramble

namespace mc {

void owen_scramble(std::span<double> column, std::uint64_t seed) {
  const std::uint64_t hashed = mix_bits(mix_bits(seed) + 1);
  for (double& value : column) {
    const auto word = static_cast<std::uint64_t>(value * 0x1p53) << 11;
    std::uint64_t flips = 0;
    for (unsigned k = 0; k < 53; ++k) {
      const std::uint64_t before = k == 0 ? 0 : word >> (64 - k);
      flips |= mix_bits(mix_bits(hashed ^ before)) >> 63 << (63 - k);
    }
    value = static_cast<double>((word ^ flips) >> 11) * 0x1p-53;
  }
}

}  // namespace mc
