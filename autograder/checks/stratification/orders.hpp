#pragma once
// Tests of random permutations: all equally likely, no repeats, independent.

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
  void add(const Order& order) { append(values, order); }
};

/// The permutations are independent, and all n! equally likely: the numbers that determine them,
/// read from either end, and the signs of products of three are uniform, and for n >= 20 no
/// permutation repeats (of R permutations out of M, R^2 / 2M do: this detects M up to R^2 / 40).
/// `only_repeats` skips the other tests. `claim.repeated` is the hint for a repeat.
void expect_random_permutations(const Permutations& orders, const Randomness& claim, Rng& rng,
                                bool only_repeats = false);

/// The random choices behind the first permutation, of at least 2^17 values, are uniform to the
/// last bit. A shuffle puts one of the n - k remaining values at place k from an end; few of the
/// first 5000 have moved before, so the values show the choices, in the order or its inverse.
void expect_fine_choices(const Permutations& orders, Randomness claim, Rng& rng);

/// The cells of the points of some sets in turn, in the order of the points, for each pattern.
Permutations orders_of(const Stratified& made, std::size_t sets, Rng& rng);

/// For random pairs of patterns of each set, the order of one (or its reverse) in the other.
Permutations meetings_of(const Stratified& made, std::size_t sets, Rng& rng);

}  // namespace mc::checks
