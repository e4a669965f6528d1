// Mistakes in task 5.2.
#include "halton.hpp"

#define radical_inverses right_radical_inverses
#include "solutions/halton.cpp"
#undef radical_inverses

// mistake: adds each digit to the previous contents of the column
// hint: never written, only added to
namespace mc::adds_into_the_column {
void radical_inverses(unsigned base, std::uint64_t first, std::span<double> column) {
  std::vector<double> more(column.size());
  right_radical_inverses(base, first, more);
  for (std::size_t i = 0; i < column.size(); ++i) column[i] += more[i];
}
}  // namespace mc::adds_into_the_column

// mistake: starts a column where the block of its first index starts
// hint: these radical inverses start at index
namespace mc::blocks_from_their_beginning {
void radical_inverses(unsigned base, std::uint64_t first, std::span<double> column) {
  require_base(base);
  require_indices(first, column.size(), last_index);
  right_radical_inverses(base, first - first % (std::uint64_t{base} * base), column);
}
}  // namespace mc::blocks_from_their_beginning

// mistake: keeps the first index in 32 bits
// hint: truncated to 32 bits
namespace mc::first_of_32_bits {
void radical_inverses(unsigned base, std::uint64_t first, std::span<double> column) {
  require_indices(first, column.size(), last_index);
  right_radical_inverses(base, static_cast<std::uint32_t>(first), column);
}
}  // namespace mc::first_of_32_bits

// mistake: fills only whole blocks of four values
// hint: never written
namespace mc::last_values_unwritten {
void radical_inverses(unsigned base, std::uint64_t first, std::span<double> column) {
  right_radical_inverses(base, first, column.first(column.size() / 4 * 4));
  require_indices(first, column.size(), last_index);
}
}  // namespace mc::last_values_unwritten
