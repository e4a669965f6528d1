// alternative: digits permuted by sorting random keys, with a generator for each position
#include "halton.hpp"

#define radical_inverses_scrambled right_radical_inverses_scrambled
#include "solutions/halton.cpp"

#include <algorithm>
#undef radical_inverses_scrambled

namespace mc {

void radical_inverses_scrambled(unsigned base, std::uint64_t first, std::span<double> column,
                                std::uint64_t seed) {
  require_base(base);
  if (base > 65536) throw std::invalid_argument("base: above 2^16");
  require_indices(first, column.size(), last_index);
  std::vector<std::vector<unsigned>> permutations;
  for (double size = 1; size < 0x1p64; size *= base) {
    Rng rng(mix_bits(seed) + permutations.size());
    std::vector<std::pair<std::uint64_t, unsigned>> keys(base);
    for (unsigned digit = 0; digit < base; ++digit) keys[digit] = {rng(), digit};
    std::sort(keys.begin(), keys.end());
    permutations.emplace_back();
    for (const auto& key : keys) permutations.back().push_back(key.second);
  }
  for (std::size_t i = 0; i < column.size(); ++i) {
    std::uint64_t index = first + i;
    unsigned __int128 mirrored = 0;  // below base^positions < 2^64 base
    double size = 1;
    for (const auto& permutation : permutations) {
      mirrored = mirrored * base + permutation[index % base];
      index /= base;
      size *= base;
    }
    column[i] = std::min(below_one, static_cast<double>(mirrored) / size);
  }
}

}  // namespace mc
