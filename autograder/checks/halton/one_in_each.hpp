#pragma once
// What permuted digits keep of a sequence.

#include <algorithm>
#include <cmath>
#include <span>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "checks/support/expect.hpp"

namespace mc::checks {

/// Of consecutive values from a multiple of their number on, one lies in each of as many parts of
/// [0, 1), all at the same place in their part.
inline void expect_one_in_each(const std::string& call, std::span<const double> x) {
  const std::size_t parts = x.size();
  const double least = *std::min_element(x.begin(), x.end());
  std::vector<int> points(parts);
  for (const double value : x) {
    const double part = (value - least) * static_cast<double>(parts);
    const auto whole = static_cast<std::size_t>(std::llround(part));
    if (std::abs(part - std::round(part)) < 1e-6 && whole < parts) ++points[whole];
  }
  expect_that(
      least < 1 / static_cast<double>(parts) + 1e-9 &&
          std::all_of(points.begin(), points.end(), [](int k) { return k == 1; }),
      fmt::format("{}: not one value in each of {} parts", call, parts),
      fmt::format("one value in each of {} parts, all at the same place in their part", parts),
      "the last digits take all their combinations, and so do their permutations",
      "a permutation is a bijection, one for each position and not one for each digit "
      "before it");
}

}  // namespace mc::checks
