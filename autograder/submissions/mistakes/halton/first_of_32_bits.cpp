// mistake: the first index is kept in 32 bits
// caught by: 5.2 a column may begin anywhere
// hint: of which 32 were kept
#include "halton.hpp"

#define radical_inverses right_radical_inverses
#include "solutions/halton.cpp"
#undef radical_inverses

namespace mc {

void radical_inverses(unsigned base, std::uint64_t first, std::span<double> column) {
  require_indices(first, column.size(), last_index);
  right_radical_inverses(base, static_cast<std::uint32_t>(first), column);
}

}  // namespace mc
