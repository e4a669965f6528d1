// alternative: Owen's scrambling by a hash in the manner of Laine and Karras, as Vegdahl has it, in
// one word of 64 bits
#include "halton.hpp"

#define owen_scramble right_owen_scramble
#include "solutions/halton.cpp"
#undef owen_scramble

namespace mc {
namespace {

std::uint64_t mirrored_64(std::uint64_t word) {
  std::uint64_t result = 0;
  for (int bit = 0; bit < 64; ++bit) result = result << 1 | (word >> bit & 1);
  return result;
}

}  // namespace

void owen_scramble(std::span<double> column, std::uint64_t seed) {
  const std::uint64_t add = mix_bits(mix_bits(seed) ^ 0x5bf03635u);
  const std::uint64_t multiply = mix_bits(add + 1) | 1;
  for (double& value : column) {
    std::uint64_t z = mirrored_64(static_cast<std::uint64_t>(value * 0x1p53) << 11);
    z ^= z * 0x3d20adea3d20adeau;
    z += add;
    z *= multiply;
    z ^= z * 0x05526c5605526c56u;
    z ^= z * 0x53a2286453a22864u;
    value = static_cast<double>(mirrored_64(z) >> 11) * 0x1p-53;
  }
}

}  // namespace mc
