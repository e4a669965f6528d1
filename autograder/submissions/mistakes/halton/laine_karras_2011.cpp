// mistake: the constants of Laine and Karras 2011, where the seed is only added: not Owen's variance
// caught by: 5.8 a scrambled net
// caught by: 5.8 each bit
// hint: nested uniform scrambling
#include "halton.hpp"

#define owen_scramble right_owen_scramble
#include "solutions/halton.cpp"
#undef owen_scramble

namespace mc {

void owen_scramble(std::span<double> column, std::uint64_t seed) {
  Rng rng(seed);
  const std::uint64_t word = rng();
  for (double& value : column) {
    auto low = static_cast<std::uint64_t>(value * 0x1p53) << 11;
    std::uint64_t z = std::uint64_t{mirrored(static_cast<std::uint32_t>(low))} << 32 |
                      mirrored(static_cast<std::uint32_t>(low >> 32));
    z += word;
    z ^= z * 0x6c50b47cu;
    z ^= z * 0xb82f1e52u;
    z ^= z * 0xc7afe638u;
    z ^= z * 0x8d22f6e6u;
    low = std::uint64_t{mirrored(static_cast<std::uint32_t>(z))} << 32 |
          mirrored(static_cast<std::uint32_t>(z >> 32));
    value = static_cast<double>(low >> 11) * 0x1p-53;
  }
}

}  // namespace mc
