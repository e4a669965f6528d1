#pragma once
// Poisson-disk patterns as they come from a program, for checks, plots and the bench alike.

#include <cmath>
#include <cstddef>
#include <numeric>
#include <vector>

#include "4-blue-noise/experiments.hpp"
#include "checks/support/sample_sets.hpp"

namespace mc::checks {

/// About 0.7 / radius^2 points are a Poisson-disk pattern (0.696, by 400 patterns of the
/// reference): the radius for n of them.
inline double radius_for(double n) {
  return std::sqrt(0.7 / n);
}

/// What is expected of x, y and sizes of so many patterns. A radius fills a torus with 1.155 /
/// radius^2 points at most, and half of it with four times as many: enough to see that it was
/// halved, and a bound for what is worth looking at.
inline std::vector<ListSpec> patterns_spec(double radius, std::size_t sets) {
  const double most = std::ceil(4 * 1.155 / (radius * radius) + 4);
  const std::size_t points = static_cast<std::size_t>(most) * sets;
  return {{points, unit, true}, {points, unit, true}, {sets, up_to(most)}};
}

/// One pattern after the other; none where sizes do not add up.
inline SampleSets patterns_in(const std::string& call, const experiments::Patterns& all) {
  const auto sum = std::accumulate(all.sizes.begin(), all.sizes.end(), std::uint64_t{0});
  if (sum != all.x.size()) return {call, 0, 2, {}};
  return sets_from_xy(call, all.x, all.y, all.sizes);
}

/// The patterns of an answer; none where a check would end.
inline SampleSets patterns_if_any(const Measured<experiments::Patterns>& got, double radius,
                                  std::size_t sets) {
  const auto* const all = got.if_list_by_list(patterns_spec(radius, sets));
  return patterns_in(got.call, all == nullptr ? experiments::Patterns{} : *all);
}

}  // namespace mc::checks
