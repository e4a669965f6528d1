// mistake: only the first 32 bits of a value are scrambled, the others lost
// caught by: 5.8 scrambled values
// caught by: 5.8 each bit
// hint: 53 bits of a value are scrambled, not 32
#include "halton.hpp"

#include <cmath>

#define owen_scramble right_owen_scramble
#include "solutions/halton.cpp"
#undef owen_scramble

namespace mc {

void owen_scramble(std::span<double> column, std::uint64_t seed) {
  right_owen_scramble(column, seed);
  for (double& value : column) value = std::floor(value * 0x1p32) * 0x1p-32;
}

}  // namespace mc
