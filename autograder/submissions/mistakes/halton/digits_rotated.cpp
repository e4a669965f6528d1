// mistake: adds a random number to each digit, modulo the base
// caught by: 5.9 permutations are random
// caught by: 5.9 permuted digits
// hint: these are rotations
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
  for (auto row = digits.permutations.begin(); row != digits.permutations.end(); row += base) {
    const auto by = static_cast<unsigned>(rng() % base);
    for (unsigned digit = 0; digit < base; ++digit) row[digit] = (digit + by) % base;
  }
  fill(column, first, digits);
}

}  // namespace mc
