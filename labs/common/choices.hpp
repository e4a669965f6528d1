#pragma once

#include <cstddef>
#include <cstdint>

#include "common/rng.hpp"

namespace mc {

/// Makes uniform random choices, several from one random word: word * n = choice * 2^64 + rest, and
/// the rest is a random word again, with log2(n) fewer random bits. A word is reused as long as the
/// product of all n is at most 2^24. Each probability is then correct up to a factor of 1 ± 2^-40.
/// For n above 2^24 each choice takes its own word, with a factor of 1 ± n 2^-64.
/// source: Brackett-Rozinsky, Lemire 2024, "Batched ranged random integer generation".
class Choices {
 public:
  explicit Choices(Rng& rng) : rng_(rng) {}

  /// A uniform choice from 0 … n-1.
  std::size_t below(std::size_t n) {
    used_ *= n;
    if (used_ > most_used) word_ = rng_(), used_ = n;
    const auto product = static_cast<unsigned __int128>(word_) * n;
    word_ = static_cast<std::uint64_t>(product);
    return static_cast<std::size_t>(product >> 64);
  }

 private:
  static constexpr std::uint64_t most_used = 1 << 24;
  Rng& rng_;
  std::uint64_t word_ = 0, used_ = most_used;  // no word yet
};

}  // namespace mc
