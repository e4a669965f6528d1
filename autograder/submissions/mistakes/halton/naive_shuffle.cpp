// mistake: swaps each digit with any of all: some orders come more often than others
// caught by: 5.9 permutations are random
// hint: a biased shuffle
#include <cmath>

#include "halton.hpp"

#define radical_inverses_scrambled right_radical_inverses_scrambled
#include "solutions/halton.cpp"
#undef radical_inverses_scrambled

namespace mc {

void radical_inverses_scrambled(unsigned base, std::uint64_t first, std::span<double> column,
                                std::uint64_t seed) {
  require_base(base);
  if (base > 65536) throw std::invalid_argument("base: more than 2^16 digits to permute");
  require_indices(first, column.size(), last_index);
  std::vector<double> rows((1 + static_cast<std::size_t>(64 / std::log2(base))) * base);
  std::size_t position = 0;
  for (auto row = rows.begin(); row != rows.end(); row += base) {
    Rng rng(mix_bits(seed ^ mix_bits(base)) + position++);
    std::iota(row, row + base, 0);
    for (unsigned i = 0; i < base; ++i) std::swap(row[i], row[any_digit(0, base, rng)]);
  }
  fill(column, first, base, rows, 0);
}

}  // namespace mc
