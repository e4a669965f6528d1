#pragma once
// From the unit square to what scenes sample.

#include <cmath>
#include <numbers>

#include "common/points.hpp"

namespace mc::scenes {

struct Vector {
  double x = 0, y = 0, z = 0;
};

/// Uniform in the unit disk. The root makes the area inside r grow as r^2, as a disk's does.
inline Point2 in_unit_disk(Point2 u) {
  const double r = std::sqrt(u.x), phi = 2 * std::numbers::pi * u.y;
  return {r * std::cos(phi), r * std::sin(phi)};
}

/// A direction at the height `z` above the horizon, turned by u in [0,1).
inline Vector direction(double z, double u) {
  const double r = std::sqrt(1 - z * z), phi = 2 * std::numbers::pi * u;
  return {r * std::cos(phi), r * std::sin(phi), z};
}

/// Uniform on the hemisphere around z: by Archimedes, its height is uniform.
inline Vector uniform_direction(Point2 u) {
  return direction(u.x, u.y);
}

/// With density cos / pi: a uniform point of the disk, lifted onto the sphere (Malley's method).
inline Vector cosine_direction(Point2 u) {
  return direction(std::sqrt(1 - u.x), u.y);
}

}  // namespace mc::scenes
