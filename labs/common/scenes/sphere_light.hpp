#pragma once
// The irradiance from a spherical light. Two dimensions: a direction toward the light.

#include <cmath>
#include <numbers>

#include "6-sampler/sampler.hpp"
#include "common/scenes/mappings.hpp"

namespace mc::scenes {

/// A sphere of radiance 1 whose center is at `distance` > radius from the receiver, at the angle
/// `tilt` from its normal. The whole sphere is above the horizon.
struct SphereLight {
  double radius = 1, distance = 2.5, tilt = 0.6;

  static constexpr std::string_view uses = "next2";

  /// Directions are uniform in the cone that the sphere subtends, so the value of a sample is the
  /// solid angle of the cone times the receiver's cosine.
  double operator()(Sampler& sampler) const {
    const Point2 u = sampler.next2();
    const double sine = radius / distance;
    const double cap = sine * sine / (1 + std::sqrt(1 - sine * sine));  // 1 - cos, stably
    const Vector w = direction(1 - cap * u.x, u.y);                     // around the cone's axis
    const double cosine = std::cos(tilt) * w.z - std::sin(tilt) * w.x;
    return 2 * std::numbers::pi * cap * cosine;
  }
};

}  // namespace mc::scenes
