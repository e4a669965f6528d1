#pragma once
// Radical inverses, primes and Sobol' points by their definitions, to judge by.

#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "checks/support/exact.hpp"
#include "checks/support/sobol_exact.hpp"

namespace mc::checks {

inline constexpr double half_ulp = 0x1p-53;  // half a unit in the last place of 1
/// The bound of the header, and what rounding the exact fraction to a double adds.
inline constexpr double inverse_tolerance = 4.5 * half_ulp;
inline constexpr std::uint64_t last_index = std::numeric_limits<std::uint64_t>::max();

/// Indices first, first + 1, …
inline std::vector<std::uint64_t> indices_from(std::uint64_t first, std::size_t n) {
  std::vector<std::uint64_t> indices(n);
  for (std::uint64_t& index : indices) index = first++;
  return indices;
}

/// The radical inverse, right to 100 bits: from the first digit of the index to the last.
inline Exact exact_inverse(unsigned base, std::uint64_t index) {
  std::vector<unsigned> digits;
  for (; index > 0; index /= base) digits.push_back(static_cast<unsigned>(index % base));
  Exact value;
  for (auto digit = digits.rbegin(); digit != digits.rend(); ++digit) {
    value = (value + Exact(*digit)) / Exact(base);
  }
  return value;
}

inline double inverse(unsigned base, std::uint64_t index) {
  return static_cast<double>(exact_inverse(base, index));
}

/// Of first, first + 1, …
inline std::vector<double> inverses(unsigned base, std::uint64_t first, std::size_t n) {
  std::vector<double> x(n);
  for (double& value : x) value = inverse(base, first++);
  return x;
}

/// i/N: the first axis of Hammersley points.
inline std::vector<double> steps(std::size_t n) {
  std::vector<double> x(n);
  for (std::size_t i = 0; i < n; ++i) x[i] = static_cast<double>(i) / static_cast<double>(n);
  return x;
}

inline std::vector<unsigned> sieved_primes(unsigned limit) {
  std::vector<bool> composite(limit);
  std::vector<unsigned> found;
  for (unsigned n = 2; n < limit; ++n) {
    if (composite[n]) continue;
    found.push_back(n);
    for (unsigned multiple = 2 * n; multiple < limit; multiple += n) composite[multiple] = true;
  }
  return found;
}

inline double sobol_value(std::span<const std::uint32_t> v, std::uint64_t index) {
  return sobol_word(v, index) * 0x1p-32;
}

inline std::vector<double> sobol_points(unsigned dimension, std::uint64_t first, std::size_t n) {
  const auto v = sobol_directions(dimension);
  std::vector<double> x(n);
  for (double& value : x) value = sobol_value(v, first++);
  return x;
}

}  // namespace mc::checks
