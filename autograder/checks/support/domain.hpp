#pragma once
// Inputs for checks, by kind of argument. Bugs hide at the limits of what a header allows, on both
// sides of powers of two, and at sizes that are not multiples of a block.
//
// Lists begin with an ordinary value, for readable reports, and end with the smallest.

#include <cstdint>
#include <limits>
#include <numeric>
#include <vector>

#include "common/rng.hpp"

namespace mc::checks {

inline constexpr double eps = std::numeric_limits<double>::epsilon();
inline constexpr double infinity = std::numeric_limits<double>::infinity();
inline constexpr double nan = std::numeric_limits<double>::quiet_NaN();

/// Uniform in [0, 1), with 53 bits.
inline double uniform(Rng& rng) {
  return static_cast<double>(rng() >> 11) * 0x1p-53;
}

inline double uniform(Rng& rng, double low, double high) {
  return low + (high - low) * uniform(rng);
}

inline std::vector<double> uniform_values(Rng& rng, std::size_t n, double low, double high) {
  std::vector<double> x(n);
  for (double& value : x) value = uniform(rng, low, high);
  return x;
}

template <class T, class More>
void append(std::vector<T>& all, const More& more) {
  all.insert(all.end(), more.begin(), more.end());
}

/// A seed that is short enough to type.
inline std::uint64_t fresh_seed(Rng& rng) {
  return rng() >> 32;
}

}  // namespace mc::checks

namespace mc::checks::domain {

/// Sizes of lists, at most `most`: ordinary ones, both sides of powers of two, primes, a random
/// one.
inline std::vector<std::uint64_t> sizes(std::uint64_t most, Rng& rng) {
  std::vector<std::uint64_t> all{12,  100, 37,  15,   16,   17,   63,   64,   65,    127,
                                 129, 255, 257, 1000, 1023, 1025, 4095, 4097, 65537, 999983};
  all.push_back(2 + rng() % std::max<std::uint64_t>(most, 3) % 5000);
  all.insert(all.end(), {9, 8, 7, 5, 4, 3, 2, 1});
  std::erase_if(all, [=](std::uint64_t n) { return n > most; });
  return all;
}

/// 64-bit integers up to `last`: small ones, powers of two, their neighbors, random ones, the last
/// two.
inline std::vector<std::uint64_t> words(std::uint64_t last, Rng& rng) {
  std::vector<std::uint64_t> all{6, 11, 100, 12345};
  for (int bit = 1; bit < 64; ++bit) {
    const std::uint64_t power = std::uint64_t{1} << bit;
    all.insert(all.end(), {power - 1, power, power + 1, power + (rng() & (power - 1))});
  }
  all.insert(all.end(), {last - 1, last, 1, 0});
  std::erase_if(all, [=](std::uint64_t n) { return n > last; });
  return all;
}

/// A random seed and the 64 seeds that differ from it in one bit; `times` times.
inline std::vector<std::uint64_t> seeds_by_bit(Rng& rng, std::size_t times = 1) {
  std::vector<std::uint64_t> all;
  for (std::size_t i = 0; i < times; ++i) {
    const std::uint64_t seed = rng();
    all.push_back(seed);
    for (int bit = 0; bit < 64; ++bit) all.push_back(seed ^ std::uint64_t{1} << bit);
  }
  return all;
}

/// A random seed and those that careless mixing makes equal to it: ~s and -s; `times` times.
inline std::vector<std::uint64_t> seeds_and_opposites(Rng& rng, std::size_t times) {
  std::vector<std::uint64_t> all;
  for (std::size_t i = 0; i < times; ++i) {
    const std::uint64_t seed = rng();
    all.insert(all.end(), {seed, ~seed, ~seed + 1});
  }
  return all;
}

inline std::vector<std::uint64_t> seeds(Rng& rng, std::size_t count) {
  std::vector<std::uint64_t> all(count);
  for (auto& seed : all) seed = rng();
  return all;
}

/// `count` seeds or indices in a row: first, first + 1, …
inline std::vector<std::uint64_t> in_a_row(std::uint64_t first, std::size_t count) {
  std::vector<std::uint64_t> all(count);
  std::iota(all.begin(), all.end(), first);
  return all;
}

/// Random words for Rng::constant(): all ones, all zeros, a random word.
inline std::vector<std::uint64_t> constant_words(Rng& rng) {
  return {~std::uint64_t{0}, 0, rng()};
}

}  // namespace mc::checks::domain
