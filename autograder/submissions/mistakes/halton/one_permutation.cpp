// mistake: the same permutation at every position
// caught by: 5.9 permutations are random
// hint: one permutation for all positions
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
  const auto row = rows.begin();
  std::iota(row, row + base, 0);
  std::shuffle(row, row + base, rng);
  for (std::size_t i = base; i < rows.size(); ++i) {
    rows[i] = rows[i - base];
  }
  fill(column, first, base, rows, 0);
}

}  // namespace mc
