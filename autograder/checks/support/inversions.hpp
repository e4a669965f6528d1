#pragma once
// Inverts randomized constructions to the uniform numbers that they were made from, for
// expect_independent_uniforms() (battery.hpp).

#include <bit>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "checks/support/battery.hpp"
#include "checks/support/domain.hpp"

namespace mc::checks {

/// Joins each replicate of one measurement with the same replicate of another: anything that two
/// seeds or calls have in common appears as dependent positions.
inline Uniforms side_by_side(const Uniforms& a, const Uniforms& b) {
  Uniforms both{a.call + " and " + b.call, a.positions + b.positions};
  both.bits = std::min(a.bits, b.bits);
  for (std::size_t r = 0; r < std::min(a.replicates(), b.replicates()); ++r) {
    for (const Uniforms* one : {&a, &b}) {
      append(both.values, std::span(one->values).subspan(r * one->positions, one->positions));
    }
  }
  return both;
}

inline Uniforms some_of(const Uniforms& all, const std::vector<std::size_t>& positions) {
  Uniforms some{all.call, positions.size(), {}, all.bits};
  for (std::size_t r = 0; r < all.replicates(); ++r) {
    for (const std::size_t at : positions) {
      some.values.push_back(all.values[r * all.positions + at]);
    }
  }
  some.name = [name = all.name, positions](std::size_t i) { return name(positions[i]); };
  return some;
}

/// The accurate bits of the jitter n x - i in one of n strata: x has 53 bits, and n x is rounded.
inline int bits_of_jitter(std::size_t n) {
  return 52 - static_cast<int>(std::bit_width(n - 1));
}

/// The position of x within its stratum, of n strata of [0, 1).
inline double jitter_of(double x, std::size_t n) {
  const double scaled = x * static_cast<double>(n);
  return std::clamp(scaled - std::floor(scaled), 0.0, 1 - 0x1p-53);
}

/// Maps an integer k of 0 … n-1, all equally likely, to a uniform number (k + v) / n, v random.
inline double fill_cell(std::size_t k, std::size_t n, Rng& rng) {
  const double u = (static_cast<double>(k) + uniform(rng)) / static_cast<double>(n);
  return std::min(u, 1 - 0x1p-53);
}

/// The n - 1 independent uniform numbers that determine a random permutation of 0 … n-1: for each
/// value, how many smaller ones come after it (its Lehmer code; Knuth, TAOCP 3, 5.1.1).
inline std::vector<double> uniforms_of_permutation(std::span<const std::size_t> order, Rng& rng) {
  const std::size_t n = order.size();
  std::vector<std::size_t> taken(n + 1);  // a Fenwick tree: how many smaller values were seen
  std::vector<double> uniforms;
  uniforms.reserve(n);
  for (std::size_t i = 0; i + 1 < n; ++i) {
    std::size_t smaller = order[i];
    for (std::size_t k = order[i]; k > 0; k &= k - 1) smaller -= taken[k];
    for (std::size_t k = order[i] + 1; k <= n; k += k & (~k + 1)) ++taken[k];
    uniforms.push_back(fill_cell(smaller, n - i, rng));
  }
  return uniforms;
}

/// The 53 bits of a value in [0, 1).
inline std::uint64_t bits_of(double x) {
  return static_cast<std::uint64_t>(x * 0x1p53);
}

/// How many of their 53 leading bits two values share.
inline int shared_bits(double a, double b) {
  return std::countl_zero((bits_of(a) ^ bits_of(b)) << 11 | 1u << 10);
}

/// Nested uniform scrambling in base 2 flips each bit at random, depending on the bits before it.
/// For each new value, the flips that no earlier value shows, as a number; other bits are random.
inline std::vector<double> uniforms_of_flips(std::span<const double> values,
                                             std::span<const double> scrambled, Rng& rng) {
  std::vector<double> uniforms;
  for (std::size_t j = 0; j < values.size(); ++j) {
    int decided = 0;  // flips that an earlier value shows: of the shared bits and the next one
    for (std::size_t i = 0; i < j; ++i) {
      decided = std::max(decided, shared_bits(values[i], values[j]) + 1);
    }
    if (decided >= 53) continue;
    const std::uint64_t flips = (bits_of(scrambled[j]) ^ bits_of(values[j])) << decided;
    const std::uint64_t all = (std::uint64_t{1} << 53) - 1, own = (rng() >> 11) & ~(all << decided);
    uniforms.push_back(static_cast<double>((flips & all) | own) * 0x1p-53);
  }
  return uniforms;
}

}  // namespace mc::checks
