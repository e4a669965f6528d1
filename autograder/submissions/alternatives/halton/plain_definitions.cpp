// alternative: columns value by value, and a hash for every bit that Owen flips
#include "halton.hpp"

#define radical_inverses right_radical_inverses
#define sobol right_sobol
#define owen_scramble right_owen_scramble
#include "solutions/halton.cpp"
#undef radical_inverses
#undef sobol
#undef owen_scramble

namespace mc {

void radical_inverses(unsigned base, std::uint64_t first, std::span<double> column) {
  require_base(base);
  require_indices(first, column.size(), last_index);
  for (std::size_t i = 0; i < column.size(); ++i) column[i] = radical_inverse(base, first + i);
}

void sobol(unsigned dimension, std::uint64_t first, std::span<double> column) {
  if (dimension >= joe_kuo.size()) throw std::invalid_argument("dimension: 32 or more");
  require_indices(first, column.size(), 0xffffffffu);
  const Directions v = directions_of(joe_kuo[dimension]);
  for (std::size_t i = 0; i < column.size(); ++i) column[i] = sobol_word(v, first + i) * 0x1p-32;
}

void owen_scramble(std::span<double> column, std::uint64_t seed) {
  const std::uint64_t hashed = mix_bits(mix_bits(seed) + 1);
  for (double& value : column) {
    const auto word = static_cast<std::uint64_t>(value * 0x1p53) << 11;
    std::uint64_t flips = 0;
    for (unsigned k = 0; k < 53; ++k) {
      const std::uint64_t before = k == 0 ? 0 : word >> (64 - k);
      flips |= mix_bits(mix_bits(hashed ^ before) + k) >> 63 << (63 - k);
    }
    value = static_cast<double>((word ^ flips) >> 11) * 0x1p-53;
  }
}

}  // namespace mc
