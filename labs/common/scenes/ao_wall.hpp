#pragma once
// Ambient occlusion next to a wall: the cosine-weighted fraction of the sky that is visible. Two
// dimensions: a direction.

#include "6-sampler/sampler.hpp"
#include "common/scenes/mappings.hpp"

namespace mc::scenes {

/// An infinitely long wall at x = distance, from the ground up to `height`.
struct WallOcclusion {
  double distance = 1, height = 0.75;

  static constexpr std::string_view uses = "next2";

  /// Directions have the density cos / pi, so the value of a sample is the visibility, 0 or 1. A
  /// direction with w.x > 0 meets the plane of the wall at z = distance w.z / w.x.
  double operator()(Sampler& sampler) const {
    const Vector w = cosine_direction(sampler.next2());
    return w.x > 0 && distance * w.z < height * w.x ? 0 : 1;
  }
};

}  // namespace mc::scenes
