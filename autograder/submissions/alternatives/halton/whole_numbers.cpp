// alternative: mirrored digits as one whole number, divided once; a sieve; Sobol' points in steps
#include "halton.hpp"

#define radical_inverse right_radical_inverse
#define primes right_primes
#define sobol right_sobol
#include "solutions/halton.cpp"

#include <algorithm>
#undef radical_inverse
#undef primes
#undef sobol

namespace mc {

double radical_inverse(unsigned base, std::uint64_t index) {
  require_base(base);
  unsigned __int128 mirrored = 0;
  double size = 1;
  for (; index > 0; index /= base, size *= base) mirrored = mirrored * base + index % base;
  return std::min(below_one, static_cast<double>(mirrored) / size);
}

std::vector<unsigned> primes(std::size_t count) {
  std::vector<unsigned> found;
  for (std::size_t limit = 64; found.size() < count; limit *= 4) {
    found.clear();
    std::vector<bool> composite(limit);
    for (std::size_t n = 2; n < limit && found.size() < count; ++n) {
      if (composite[n]) continue;
      found.push_back(static_cast<unsigned>(n));
      for (std::size_t multiple = n * n; multiple < limit; multiple += n)
        composite[multiple] = true;
    }
  }
  return found;
}

void sobol(unsigned dimension, std::uint64_t first, std::span<double> column) {
  if (dimension >= joe_kuo.size()) throw std::invalid_argument("dimension: not in the table");
  require_indices(first, column.size(), 0xffffffffu);
  const auto v = definition::directions_of(joe_kuo[dimension]);
  std::uint32_t word = definition::sobol_word(v, first);
  for (std::size_t i = 0; i < column.size(); ++i) {
    column[i] = word * 0x1p-32;
    const std::uint64_t next = first + i + 1;  // the bits that change: the last set one of it, and
    for (unsigned bit = 0; bit < 32; ++bit) {  // all below
      word ^= v[bit];
      if (next >> bit & 1) break;
    }
  }
}

}  // namespace mc
