#pragma once
// Mappings from the unit square to the domains that scenes sample. Coordinates are in [0,1).

#include <cmath>
#include <numbers>

#include "common/points.hpp"

namespace mc::scenes {

/// A vector in space; z points away from the surface.
struct Vector {
  double x = 0, y = 0, z = 0;
};

/// A uniform point in the unit disk. The square root makes P(radius < r) = r^2, which is
/// proportional to the area inside radius r.
inline Point2 in_unit_disk(Point2 u) {
  const double r = std::sqrt(u.x), phi = 2 * std::numbers::pi * u.y;
  return {r * std::cos(phi), r * std::sin(phi)};
}

/// The unit vector whose z coordinate is `z`, turned around the z axis by `u` of a full turn.
/// requires: z in [-1,1].
inline Vector direction(double z, double u) {
  const double r = std::sqrt(1 - z * z), phi = 2 * std::numbers::pi * u;
  return {r * std::cos(phi), r * std::sin(phi), z};
}

/// A uniform direction in the hemisphere around z: its z coordinate is uniform (Archimedes).
inline Vector uniform_direction(Point2 u) {
  return direction(u.x, u.y);
}

/// A direction in the hemisphere around z with density cos / pi: a uniform point in the unit disk,
/// projected up to the hemisphere.
/// source: Malley's method: Pharr, Jakob, Humphreys 2023, "Physically based rendering", appendix
///   A.5.3.
inline Vector cosine_direction(Point2 u) {
  return direction(std::sqrt(1 - u.x), u.y);
}

}  // namespace mc::scenes
