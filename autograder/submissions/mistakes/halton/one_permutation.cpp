// mistake: the same permutation at every position
// caught by: 5.9 permutations are random
// hint: one permutation for all positions
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
  Digits digits{base, std::vector<unsigned>(std::size_t{digits_of(last_index, base)} * base)};
  Rng rng(seed ^ mix_bits(base));
  const auto row = digits.permutations.begin();
  std::iota(row, row + base, 0u);
  std::shuffle(row, row + base, rng);
  for (std::size_t i = base; i < digits.permutations.size(); ++i) {
    digits.permutations[i] = digits.permutations[i - base];
  }
  fill(column, first, digits);
}

}  // namespace mc
