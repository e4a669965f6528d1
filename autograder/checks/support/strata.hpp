#pragma once
// Strata of the line, whose edges are i / n divided in double, and grids.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <span>
#include <string>

#include "common/points.hpp"

namespace mc::checks {

/// The stratum i of n with double(i) / n <= x < double(i+1) / n; empty outside [0,1).
inline std::optional<std::size_t> stratum_of(double x, std::size_t n) {
  if (!(x >= 0 && x < 1)) return {};
  const auto size = static_cast<double>(n);
  auto i = std::min(static_cast<std::size_t>(x * size), n - 1);  // off by one at most
  while (x < static_cast<double>(i) / size) --i;
  while (x >= static_cast<double>(i + 1) / size) ++i;
  return i;
}

/// The most square grid of n cells.
inline Grid squarest(std::size_t n) {
  auto ny = static_cast<std::size_t>(std::sqrt(static_cast<double>(n)));  // exact below 2^52
  while (ny > 1 && n % ny != 0) --ny;
  return {n / std::max<std::size_t>(ny, 1), std::max<std::size_t>(ny, 1)};
}

/// The well-known wrong shuffle that explains these permutations of n <= 5 values, if one does.
Likely shuffle_hint(std::span<const std::size_t> orders, std::size_t n);

}  // namespace mc::checks
