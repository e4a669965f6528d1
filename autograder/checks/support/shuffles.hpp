#pragma once
// What well-known wrong shuffles make of a few values.

#include <cstddef>
#include <span>
#include <string>

namespace mc::checks {

/// Permutations of n <= 5 values, one after the other, are not all equally likely: the well-known
/// mistake that explains them, else `otherwise`.
std::string shuffle_hint(std::span<const std::size_t> orders, std::size_t n,
                         const std::string& otherwise);

}  // namespace mc::checks
