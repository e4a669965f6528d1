#pragma once

#include <cstdint>
#include <limits>

namespace mc {

/// Mixes all bits of `z` into all bits of the result; a bijection of 64-bit words.
/// SplitMix64's finaliser (Steele, Lea, Flood 2014, with Stafford's variant 13 of its constants).
constexpr std::uint64_t mix_bits(std::uint64_t z) {
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
  return z ^ (z >> 31);
}

/// A uniform random bit generator: 64 independent-looking bits a call, for <random> and for you.
///
/// It is a counter that is mixed on the way out, so its whole state is one word and any number of
/// generators can stand side by side. Seeds are hashed twice before they become a counter: 1, 2, 3
/// and any multiples of the increment give streams that have nothing to do with each other.
class Rng {
 public:
  using result_type = std::uint64_t;

  explicit constexpr Rng(std::uint64_t seed)
      : counter_(mix_bits(mix_bits(seed + increment) ^ 0x6a09e667f3bcc909u)) {}

  /// A generator that returns `word` for ever: for the corner cases (all bits zero, all bits one).
  /// An honest rejection loop or shuffle may never end on it.
  static constexpr Rng constant(std::uint64_t word) {
    Rng rng(0);
    rng.random_bits_ = 0;
    rng.fixed_bits_ = word;
    return rng;
  }

  static constexpr result_type min() { return 0; }
  static constexpr result_type max() { return std::numeric_limits<result_type>::max(); }

  constexpr result_type operator()() {
    counter_ += increment;
    return (mix_bits(counter_) & random_bits_) | fixed_bits_;
  }

 private:
  static constexpr std::uint64_t increment = 0x9e3779b97f4a7c15u;  // 2^64 / golden ratio, odd
  std::uint64_t counter_;
  std::uint64_t random_bits_ = ~std::uint64_t{0};  // a constant generator keeps none of them
  std::uint64_t fixed_bits_ = 0;
};

}  // namespace mc
