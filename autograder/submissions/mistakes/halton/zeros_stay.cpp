// mistake: permutes the digits that an index has, and not the zeros before its first one
// caught by: 5.9 each position
// caught by: 5.9 permutations are random
// hint: the zeros behind the last digit are digits too
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
  Rng rng(seed ^ mix_bits(base));
  for (auto row = rows.begin(); row != rows.end(); row += base) {
    std::iota(row, row + base, 0);
    std::shuffle(row, row + base, rng);
  }
  for (std::size_t i = 0; i < column.size(); ++i) {
    double value = 0, part = 1;
    std::size_t position = 0;
    for (std::uint64_t index = first + i; index > 0; index /= base) {
      part /= base;
      value += part * rows[position++ * base + index % base];
    }
    column[i] = std::min(below_one, value);
  }
}

}  // namespace mc
