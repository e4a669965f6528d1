#pragma once
// What every Poisson-disk pattern must be, for 4.3 and 4.7.

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include <fmt/format.h>

#include "checks/blue_noise/point_sets.hpp"
#include "checks/support/discs.hpp"
#include "checks/support/expect.hpp"

namespace mc::checks {

/// Why two points are closer than the radius, as far as the points tell.
inline std::string too_close_hint(const Set& set, double radius, double least) {
  const auto n = static_cast<double>(set.x.size());
  if (least >= radius / 2 - 4 * eps && n * radius * radius > 1.155) {
    return "half the radius is kept: it is the distance of two points, and not the radius of discs "
           "that may touch";
  }
  // Of pairs that are close by accident, a part of 4/pi radius at most lies across an edge: all of
  // them do where that is no accident, or once in 10,000 patterns.
  std::size_t pairs = 0, across = 0;
  for (std::size_t i = 0; i < set.x.size() && n < 5000; ++i) {
    for (std::size_t k = 0; k < i; ++k) {
      const double dx = set.x[i] - set.x[k], dy = set.y[i] - set.y[k];
      if (std::hypot(short_way(dx), short_way(dy)) >= radius - 4 * eps) continue;
      ++pairs;
      across += std::hypot(dx, dy) >= radius - 4 * eps;
    }
  }
  const double by_accident = 4 / std::numbers::pi * radius;
  if (across == pairs && static_cast<double>(pairs) * std::log(by_accident) < std::log(1e-4)) {
    return "they are close only across an edge: the square is a torus";
  }
  return "is each new point compared with all near it, round the torus? Where a cell of a grid "
         "remembers one point, it must not have room for two";
}

/// Every point has a disc of that radius to itself, but for rounding.
inline void require_apart(const std::string& call, const Set& set, double radius) {
  const double least = least_distance(set.x, set.y);
  const bool holds = least >= radius - 4 * eps;
  expect_that(holds, fmt::format("{}: two points {} apart", call, least),
              fmt::format("{} or more", radius),
              "no two points are closer than the radius, but for rounding (4 eps of the square)",
              holds ? "" : too_close_hint(set, radius, least));
}

}  // namespace mc::checks
