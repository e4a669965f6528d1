#pragma once
// How the errors of scrambled points are distributed, beyond their mean square.

#include "measurements/halton/methods.hpp"
#include "measurements/support/integrands.hpp"

namespace mc::measurements {

/// Of the mean of exp(x) over the first n points of base 2, scrambled by 5.8 in so many ways.
inline ErrorSums errors_of_exp(std::uint64_t n, std::uint64_t sets) {
  return errors_of(method(methods, "scrambled_sobol"), integrand("smooth 1D"), n, sets, n << 20);
}

/// The bits of a word in reverse order.
inline std::uint64_t reversed(std::uint64_t word) {
  std::uint64_t all = 0;
  for (int bit = 0; bit < 64; ++bit, word >>= 1) all = all << 1 | (word & 1);
  return all;
}

/// What fails beside it: base 2 scrambled here, by a hash of all bits at once that is right for
/// pairs of points only, for its one multiplication by a random number is followed by one mixing
/// step.
inline Method hashed_points() {
  return {.key = "hashed",
          .task = "",
          .name = "a hash that is right for pairs only",
          .points = [](Count n, Count, Count count, Count seed) {
            Sets sets(count, PointSet(n, 1));
            for (PointSet& set : sets) {
              Rng rng(seed++);
              const std::uint64_t shift = rng(), factor = rng() | 1;
              for (Count i = 0; i < n; ++i) {
                std::uint64_t z = i;  // its radical inverse has these bits, the first one lowest
                z ^= z << 5;
                z = z * factor + shift;
                z ^= z * 0xb82f1e52d1342544u;
                set.column(0)[i] = static_cast<double>(reversed(z) >> 11) * 0x1p-53;
              }
            }
            return sets;
          }};
}

}  // namespace mc::measurements
