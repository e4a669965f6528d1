// mistake: the first index of scrambled digits is kept in 32 bits
// caught by: 5.9 each position has a permutation
// hint: are all 64 bits of an index kept
#include "halton.hpp"

#define radical_inverses_scrambled right_radical_inverses_scrambled
#include "solutions/halton.cpp"
#undef radical_inverses_scrambled

namespace mc {

void radical_inverses_scrambled(unsigned base, std::uint64_t first, std::span<double> column,
                                std::uint64_t seed) {
  require_indices(first, column.size(), last_index);
  right_radical_inverses_scrambled(base, static_cast<std::uint32_t>(first), column, seed);
}

}  // namespace mc
