// mistake: adds a random number to each digit, modulo the base
// caught by: 5.9 permutations are random
// caught by: 5.9 permuted digits
// hint: these are rotations
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
    const auto by = static_cast<unsigned>(rng() % base);
    for (unsigned digit = 0; digit < base; ++digit) row[digit] = (digit + by) % base;
  }
  fill(column, first, base, rows, 0);
}

}  // namespace mc
