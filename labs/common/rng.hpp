#pragma once

#include <cstdint>
#include <limits>

namespace mc {

/// Mixes all bits of `z` into all bits of the result: a bijection of 64-bit words.
/// source: Steele, Lea, Flood 2014, "Fast splittable pseudorandom number generators": the finalizer
///   of SplitMix64, with variant 13 of Stafford's constants.
constexpr std::uint64_t mix_bits(std::uint64_t z) {
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
  return z ^ (z >> 31);
}

/// A uniform random bit generator in the sense of <random>: each call returns 64 random bits.
///
/// The state is one word, a counter; each call increments it and returns its mixed bits. A seed is
/// hashed twice before it becomes the counter, so the streams of seeds 1, 2, 3 are unrelated, and
/// so are those of seeds that differ by a multiple of the increment.
class Rng {
 public:
  using result_type = std::uint64_t;

  /// A generator whose numbers depend on all 64 bits of `seed`. Equal seeds give equal numbers.
  explicit constexpr Rng(std::uint64_t seed)
      : counter_(mix_bits(mix_bits(seed + increment) ^ 0x6a09e667f3bcc909u)) {}

  /// A generator that always returns `word`, for corner cases such as all bits 0 or all bits 1.
  /// With it a correct rejection loop, or a correct shuffle, may never end.
  static constexpr Rng constant(std::uint64_t word) {
    Rng rng(0);
    rng.random_bits_ = 0;
    rng.fixed_bits_ = word;
    return rng;
  }

  /// A generator whose words all have the upper 53 bits of `word`, so that to_unit() always returns
  /// the same number. The lower 11 bits are random, so that shuffles end.
  static constexpr Rng upper_bits(std::uint64_t word) {
    Rng rng(word);
    rng.random_bits_ = 0x7ff;
    rng.fixed_bits_ = word & ~rng.random_bits_;
    return rng;
  }

  static constexpr result_type min() { return 0; }
  static constexpr result_type max() { return std::numeric_limits<result_type>::max(); }

  /// The next 64 random bits.
  constexpr result_type operator()() {
    counter_ += increment;
    return (mix_bits(counter_) & random_bits_) | fixed_bits_;
  }

 private:
  static constexpr std::uint64_t increment = 0x9e3779b97f4a7c15u;  // 2^64 / golden ratio, odd
  std::uint64_t counter_;
  std::uint64_t random_bits_ = ~std::uint64_t{0};  // which bits of a word are random
  std::uint64_t fixed_bits_ = 0;                   // the values of the other bits
};

}  // namespace mc
