#pragma once
// The Sobol' sequence by its definition, from the Joe-Kuo numbers.

#include <array>
#include <bit>
#include <cstdint>
#include <span>

#include "common/joe_kuo.hpp"

namespace mc::checks {

/// The direction number of bit k of the index in dimension d: m_(k+1) of the recurrence of Bratley
/// and Fox (1988, "Algorithm 659", eq. 3), as the leading bits of a word.
inline std::array<std::uint32_t, 32> sobol_directions(unsigned d) {
  const JoeKuo& of = joe_kuo[d];
  std::array<std::uint64_t, 33> m{};
  for (unsigned k = 1; k <= 32; ++k) {
    if (of.degree == 0) {
      m[k] = 1;
    } else if (k <= of.degree) {
      m[k] = of.m[k - 1];
    } else {
      m[k] = m[k - of.degree] ^ m[k - of.degree] << of.degree;
      for (unsigned j = 1; j < of.degree; ++j) {
        if (of.coefficients >> (of.degree - 1 - j) & 1) m[k] ^= m[k - j] << j;
      }
    }
  }
  std::array<std::uint32_t, 32> directions{};
  for (unsigned k = 0; k < 32; ++k) {
    directions[k] = static_cast<std::uint32_t>(m[k + 1] << (31 - k));
  }
  return directions;
}

/// The XOR of the direction numbers of the set bits of `index`: 2^32 times the point's coordinate.
inline std::uint32_t sobol_word(std::span<const std::uint32_t> directions, std::uint64_t index) {
  std::uint32_t word = 0;
  for (auto rest = static_cast<std::uint32_t>(index); rest != 0; rest &= rest - 1) {
    word ^= directions[static_cast<std::size_t>(std::countr_zero(rest))];
  }
  return word;
}

}  // namespace mc::checks
