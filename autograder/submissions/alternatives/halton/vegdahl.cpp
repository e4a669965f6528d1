// alternative: Owen's scrambling in the manner of Laine and Karras, and Vegdahl, with a second
// random step, in one word of 64 bits
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
  Rng rng(seed);
  const std::uint64_t add = rng(), multiply = rng() | 1, add_again = rng(), again = rng() | 1;
  for (double& value : column) {
    std::uint64_t z = mirrored_64(static_cast<std::uint64_t>(value * 0x1p53) << 11);
    z ^= z * 0x3d20adea3d20adeau;
    z = z * multiply + add;
    z ^= z * 0x05526c5605526c56u;
    z = z * again + add_again;
    value = static_cast<double>(mirrored_64(z) >> 11) * 0x1p-53;
  }
}

}  // namespace mc
