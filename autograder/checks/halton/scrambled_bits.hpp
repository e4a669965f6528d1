#pragma once
// The bits of values in [0, 1), of which 53 are scrambled.

#include <bit>
#include <cstdint>

namespace mc::checks {

inline std::uint64_t bits_of(double x) {
  return static_cast<std::uint64_t>(x * 0x1p53);
}

/// Bit k of them, the first being bit 0.
inline unsigned bit_of(double x, int k) {
  return bits_of(x) >> (52 - k) & 1;
}

/// How many leading bits of 53 two values share.
inline int shared_bits(double a, double b) {
  return std::countl_zero((bits_of(a) ^ bits_of(b)) << 11 | 1u << 10);
}

}  // namespace mc::checks
