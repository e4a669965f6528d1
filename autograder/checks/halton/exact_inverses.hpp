#pragma once
// Radical inverses as they are defined, and the primes, to judge by.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "checks/support/exact.hpp"

namespace mc::checks {

inline constexpr double half_ulp = 0x1p-53;  // half a unit in the last place of 1
inline constexpr double inverse_tolerance = 4 * half_ulp;
inline constexpr std::uint64_t last_index = std::numeric_limits<std::uint64_t>::max();

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
  for (std::size_t i = 0; i < n; ++i) x[i] = inverse(base, first + i);
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

/// A number of [0, 1] in words; one that only rounds to 1 as what it is.
inline std::string shown(Exact value) {
  const auto rounded = static_cast<double>(value);
  if (rounded < 1) return fmt::format("{:.17g}", rounded);
  const auto missing = static_cast<double>(Exact(1) - value);
  return missing > 0 ? fmt::format("1 - {:.2g}", missing) : "1";
}

/// A measured number in words.
inline std::string shown_number(double value) {
  return std::isnan(value) ? "NaN" : fmt::format("{:.17g}", value == 0 ? 0 : value);
}

}  // namespace mc::checks
