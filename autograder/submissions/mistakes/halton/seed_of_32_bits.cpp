// mistake: the upper half of the seed is lost
// caught by: 5.8 all 64 bits
// hint: was the seed cut to 32 bits?
#include "halton.hpp"

#define owen_scramble right_owen_scramble
#include "solutions/halton.cpp"
#undef owen_scramble

namespace mc {

void owen_scramble(std::span<double> column, std::uint64_t seed) {
  right_owen_scramble(column, static_cast<std::uint32_t>(seed));
}

}  // namespace mc
