#pragma once
// Random permutations: all equally likely, none again, and independent of each other.

#include "checks/stratification/common.hpp"

namespace mc::checks {

using Order = std::vector<std::size_t>;    ///< a permutation of 0 … n-1
using Sizes = std::array<std::size_t, 3>;  ///< n or n per axis, dimensions, sets

/// Permutations of 0 … n-1, one after the other.
struct Permutations {
  std::string call;
  std::size_t n;
  Order values = {};

  std::size_t size() const { return values.size() / n; }
  std::span<const std::size_t> operator[](std::size_t k) const {
    return std::span(values).subspan(k * n, n);
  }
  void add(const Order& order) { values.insert(values.end(), order.begin(), order.end()); }
};

/// They are independent, and all n! equally likely: the numbers that decide them are uniform, read
/// from either end, and from n = 20 on none comes again (of R permutations that are drawn from M
/// only, R^2 / 2M do: this sees M up to R^2 / 40). Only the latter where `only_repeats`.
/// `claim.repeated` is the hint if one comes again.
void expect_random_permutations(const Permutations& orders, const Randomness& claim, Rng& rng,
                                bool only_repeats = false);

/// The first of them, of at least 2^17 values: swaps put one of the n - k values left at place k
/// from an end. Few of the first 5000 have moved before, so the values tell the choices, of the
/// order or of its inverse; they are uniform to the last bit.
void expect_fine_choices(const Permutations& orders, Randomness claim, Rng& rng);

/// Of each pattern of each set, the order in which its cells come.
Permutations orders_of(const Sets& sets, std::span<const Pattern> patterns,
                       const std::string& elsewhere);

/// Of each set, patterns put into pairs at random: the order of the second, or its reverse, where
/// the first is in order.
Permutations meetings_of(const Sets& sets, std::span<const Pattern> patterns,
                         const std::string& elsewhere, Rng& rng);

}  // namespace mc::checks
