#pragma once
// Ambient occlusion under a sphere, estimated with two densities of directions: the same expected
// value, but different variances. Two dimensions: a direction.

#include <cmath>

#include "6-sampler/sampler.hpp"
#include "common/scenes/mappings.hpp"

namespace mc::scenes {

/// A sphere whose center is at `distance` > radius from the receiver, at the angle `tilt` from its
/// normal. The whole sphere is above the horizon. Directions have the density cos / pi.
struct SphereOcclusion {
  double radius = 1, distance = 1.5, tilt = 0;

  static constexpr std::string_view uses = "next2";

  /// Whether the sphere blocks the direction `w`.
  bool hides(const Vector& w) const {
    const double cosine = std::cos(tilt) * w.z + std::sin(tilt) * w.x;
    const double sine = radius / distance;
    return cosine > 0 && cosine * cosine > 1 - sine * sine;
  }

  double operator()(Sampler& sampler) const {
    return hides(cosine_direction(sampler.next2())) ? 0 : 1;
  }
};

/// The same with uniform directions on the hemisphere, each weighted by 2 cos.
struct SphereOcclusionUniform {
  SphereOcclusion sphere;

  static constexpr std::string_view uses = "next2";

  double operator()(Sampler& sampler) const {
    const Vector w = uniform_direction(sampler.next2());
    return sphere.hides(w) ? 0 : 2 * w.z;
  }
};

}  // namespace mc::scenes
