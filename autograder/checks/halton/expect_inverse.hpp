#pragma once
// What is expected of a radical inverse, with the numbers that well-known mistakes give.

#include <span>
#include <utility>

#include "checks/halton/exact_inverses.hpp"
#include "checks/support/expect.hpp"

namespace mc::checks {

inline const char* const never_written =
    "this value was never written, or only added to: columns come filled with NaN";

/// The digits of `index` not mirrored: 6 = 110 in base 2 as .110.
inline double unmirrored(unsigned base, std::uint64_t index) {
  double size = 1;
  for (std::uint64_t rest = index; rest > 0; rest /= base) size *= base;
  return static_cast<double>(index) / size;
}

/// Mirrored digits in 32 bits, as a careless program has them.
inline double inverse_in_32_bits(unsigned base, std::uint64_t index) {
  std::uint32_t mirrored = 0;
  double size = 1;
  for (std::uint64_t rest = index; rest > 0; rest /= base, size *= base) {
    mirrored = mirrored * base + static_cast<std::uint32_t>(rest % base);
  }
  return mirrored / size;
}

/// What gives `got` in place of the radical inverse; `otherwise` where nothing fits. A suspect fits
/// to a few roundings, and where it cannot be told from the truth it is none.
inline std::string inverse_hint(double got, unsigned base, std::uint64_t index,
                                const std::string& otherwise) {
  if (std::isnan(got)) return never_written;
  const std::pair<double, const char*> suspects[] = {
      {unmirrored(base, index),
       "the digits are not mirrored: the last digit of the index comes first behind the point"},
      {inverse(base, index + 1), "this belongs to the next index: indices count from 0"},
      {inverse(base, index - 1), "this belongs to the index before"},
      {inverse(base, index & 0xffffffffu), "the index has 64 bits, of which 32 were kept"},
      {inverse_in_32_bits(base, index),
       "the mirrored digits do not fit in 32 bits: 64 are not enough for every index either"}};
  const double exact = inverse(base, index);
  const char* found = nullptr;
  for (const auto& [value, hint] : suspects) {
    if (std::abs(value - exact) <= 1e-14 || std::abs(got - value) > 1e-14) continue;
    if (found != nullptr) return otherwise;  // two mistakes give this value
    found = hint;
  }
  if (found != nullptr) return found;
  if (got == 1) return "it was rounded up to 1: hold it below";
  const bool is_float = static_cast<double>(static_cast<float>(got)) == got;
  if (is_float && std::abs(got - exact) < 1e-5) return "this is a float: it has 24 bits, not 53";
  return otherwise;
}

inline void expect_inverse(const std::string& what, double got, unsigned base, std::uint64_t index,
                           double allowed = inverse_tolerance, const std::string& otherwise = "") {
  const Exact exact = exact_inverse(base, index);
  if (got >= 0 && got < 1 && std::abs(static_cast<double>(Exact(got) - exact)) <= allowed) {
    return pass();
  }
  expect_that(
      false, fmt::format("{}: {} for index {} in base {}", what, shown_number(got), index, base),
      fmt::format("{}: at most {} * 2^-53 away from it, and below 1", shown(exact),
                  allowed / half_ulp),
      "the exact fraction, digit by digit; adding the smallest terms first keeps the error to "
      "2 * 2^-53",
      inverse_hint(got, base, index, otherwise));
}

/// Where that a value stays below 1 has a check of its own, 1 counts as the number before it.
inline double held_below_1(double value) {
  return value == 1 ? 1 - half_ulp : value;
}

/// The index from which on these are the radical inverses, of those that a mistake might begin at.
inline std::string beginning_hint(std::span<const double> got, unsigned base, std::uint64_t first,
                                  const std::string& otherwise) {
  const auto are_from = [&](std::uint64_t from) {
    for (std::size_t i = 0; i < got.size(); ++i) {
      if (!(std::abs(got[i] - inverse(base, from + i)) <= 1e-14)) return false;
    }
    return true;
  };
  std::vector<std::uint64_t> others{0, first + 1, first - 1, first & 0xffffffffu};
  for (std::uint64_t block = base; block <= first; block *= base) {
    others.push_back(first - first % block);
    if (block > last_index / base) break;
  }
  for (const std::uint64_t from : others) {
    if (from != first && are_from(from)) {
      return fmt::format("these are the radical inverses from index {} on, not from {}", from,
                         first);
    }
  }
  return otherwise;
}

inline void expect_column(const std::string& call, std::span<const double> got, unsigned base,
                          std::uint64_t first, const std::string& otherwise) {
  for (std::size_t i = 0; i < got.size(); ++i) {
    const double value = held_below_1(got[i]);
    const double error =
        std::abs(static_cast<double>(Exact(value) - exact_inverse(base, first + i)));
    if (value >= 0 && value < 1 && error <= inverse_tolerance) continue;
    expect_inverse(fmt::format("{}, value {}", call, i), value, base, first + i, inverse_tolerance,
                   beginning_hint(got, base, first, otherwise));
  }
  pass();
}

}  // namespace mc::checks
