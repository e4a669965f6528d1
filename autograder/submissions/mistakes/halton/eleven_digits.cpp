// mistake: permutes eleven digits, and drops the others: some indices get the same number
// caught by: 5.9 each position
// caught by: 5.9 permutations are random
// hint: this position has no permutation
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
  std::vector<std::vector<unsigned>> rows(11, std::vector<unsigned>(base));
  for (std::size_t position = 0; position < rows.size(); ++position) {
    Rng rng(mix_bits(seed ^ mix_bits(base)) + position);
    auto& row = rows[position];
    std::iota(row.begin(), row.end(), 0u);
    for (unsigned k = 0; k < base; ++k) std::swap(row[k], row[any_digit(k, base, rng)]);
  }
  for (std::size_t i = 0; i < column.size(); ++i) {
    std::uint64_t index = first + i;
    double value = 0, part = 1;
    for (const auto& row : rows) {
      part /= base;
      value += part * row[index % base];
      index /= base;
    }
    column[i] = std::min(below_one, value);
  }
}

}  // namespace mc
