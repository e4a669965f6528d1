// mistake: fills whole blocks of four values, and forgets the rest
// caught by: 5.2 a column has
// caught by: 5.2 a column may begin anywhere
// caught by: 5.2 every value
// hint: never written
#include "halton.hpp"

#define radical_inverses right_radical_inverses
#include "solutions/halton.cpp"
#undef radical_inverses

namespace mc {

void radical_inverses(unsigned base, std::uint64_t first, std::span<double> column) {
  right_radical_inverses(base, first, column.first(column.size() / 4 * 4));
  require_indices(first, column.size(), last_index);
}

}  // namespace mc
