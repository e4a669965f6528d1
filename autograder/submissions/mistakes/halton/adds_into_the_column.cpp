// mistake: adds each digit to what stands in the column
// caught by: 5.2 a column has
// caught by: 5.2 a column may begin anywhere
// caught by: 5.2 every value
// hint: never written, or only added to
#include "halton.hpp"

#define radical_inverses right_radical_inverses
#include "solutions/halton.cpp"
#undef radical_inverses

namespace mc {

void radical_inverses(unsigned base, std::uint64_t first, std::span<double> column) {
  std::vector<double> more(column.size());
  right_radical_inverses(base, first, more);
  for (std::size_t i = 0; i < column.size(); ++i) column[i] += more[i];
}

}  // namespace mc
