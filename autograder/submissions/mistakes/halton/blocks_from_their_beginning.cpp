// mistake: a column begins where the block of its first index begins
// caught by: 5.2 a column may begin anywhere
// hint: these are the radical inverses from index
#include "halton.hpp"

#define radical_inverses right_radical_inverses
#include "solutions/halton.cpp"
#undef radical_inverses

namespace mc {

void radical_inverses(unsigned base, std::uint64_t first, std::span<double> column) {
  require_base(base);
  require_indices(first, column.size(), last_index);
  right_radical_inverses(base, first - first % (std::uint64_t{base} * base), column);
}

}  // namespace mc
