#pragma once
// Poisson-disk patterns as they come from a program, for checks, plots and the bench alike.

#include <array>
#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

#include "4-blue-noise/experiments.hpp"
#include "checks/support/measure.hpp"

namespace mc::checks {

using View = std::span<const double>;

/// One set of points of several.
struct Set {
  View x, y;
};

/// About 0.7 / radius^2 points are a Poisson-disk pattern (0.696, by 400 patterns of the
/// reference): the radius for n of them.
inline double radius_for(double n) {
  return std::sqrt(0.7 / n);
}

/// What is due of x, y and sizes of so many patterns. A radius fills a torus with 1.155 / radius^2
/// points at most, and half of it with four times as many: enough to see that it was halved, and a
/// bound for what is worth looking at.
inline std::array<Due, 3> patterns_due(double radius, std::size_t sets) {
  const double most = std::ceil(4 * 1.155 / (radius * radius) + 4);
  const std::size_t points = static_cast<std::size_t>(most) * sets;
  return {Due{points, unit, true}, Due{points, unit, true}, Due{sets, up_to(most)}};
}

/// One pattern after the other; none where one of them is empty or sizes do not add up.
inline std::vector<Set> taken_apart(const experiments::Patterns& all) {
  std::vector<Set> sets;
  std::size_t first = 0;
  for (const std::uint64_t size : all.sizes) {
    if (size == 0 || size > all.x.size() - first) return {};
    sets.push_back({View(all.x).subspan(first, size), View(all.y).subspan(first, size)});
    first += size;
  }
  if (first != all.x.size()) return {};
  return sets;
}

/// The patterns of an answer that stays in `got`; none where a check would end.
inline std::vector<Set> patterns_if_any(const Measured<experiments::Patterns>& got, double radius,
                                        std::size_t sets) {
  const auto [x, y, sizes] = patterns_due(radius, sets);
  const auto* const all = got.if_list_by_list({x, y, sizes});
  return all == nullptr ? std::vector<Set>{} : taken_apart(*all);
}

}  // namespace mc::checks
