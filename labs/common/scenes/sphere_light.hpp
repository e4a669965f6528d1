#pragma once
// The irradiance from a ball of light. Two dimensions: which direction toward it.

#include <cmath>
#include <numbers>

#include "6-sampler/sampler.hpp"
#include "common/scenes/mappings.hpp"

namespace mc::scenes {

/// A sphere of radiance 1, its center at `distance` > radius and at the angle `tilt` from the
/// receiver's normal, all of it above the horizon.
struct SphereLight {
  double radius = 1, distance = 2.5, tilt = 0.6;

  static constexpr std::string_view uses = "next2";

  /// Directions uniform in the cone of the sphere: its solid angle times the receiver's cosine.
  double operator()(Sampler& sampler) const {
    const Point2 u = sampler.next2();
    const double sine = radius / distance;
    const double cap = sine * sine / (1 + std::sqrt(1 - sine * sine));  // 1 - cos, nothing lost
    const Vector w = direction(1 - cap * u.x, u.y);                     // around the cone's axis
    const double cosine = std::cos(tilt) * w.z - std::sin(tilt) * w.x;
    return 2 * std::numbers::pi * cap * cosine;
  }
};

}  // namespace mc::scenes
