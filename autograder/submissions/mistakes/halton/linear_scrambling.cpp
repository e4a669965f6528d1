// mistake: Matousek's random linear scrambling, a matrix and a shift: right in pairs, not in triples
// caught by: 5.8 a scrambled net
// hint: are pairs of values scrambled independently, but not triples
#include "halton.hpp"

#define owen_scramble right_owen_scramble
#include "solutions/halton.cpp"
#undef owen_scramble

namespace mc {

void owen_scramble(std::span<double> column, std::uint64_t seed) {
  Rng rng(seed);
  const std::uint64_t shift = rng() >> 11;
  std::array<std::uint64_t, 53>
      columns;  // what bit k of a value, the first being 0, does to the word
  for (unsigned k = 0; k < 53; ++k) {
    const std::uint64_t bit = std::uint64_t{1} << (52 - k);
    columns[k] = bit | (rng() & (bit - 1));
  }
  for (double& value : column) {
    const auto word = static_cast<std::uint64_t>(value * 0x1p53);
    std::uint64_t scrambled = shift;
    for (unsigned k = 0; k < 53; ++k) {
      if (word >> (52 - k) & 1) scrambled ^= columns[k];
    }
    value = static_cast<double>(scrambled) * 0x1p-53;
  }
}

}  // namespace mc
