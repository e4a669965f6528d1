#pragma once
// Ambient occlusion next to a wall: how much of the sky, weighted by the cosine, is seen. Two
// dimensions: a direction.

#include "6-sampler/sampler.hpp"
#include "common/scenes/mappings.hpp"

namespace mc::scenes {

/// An endless wall at x = distance, from the ground up to `height`.
struct WallOcclusion {
  double distance = 1, height = 0.75;

  static constexpr std::string_view uses = "next2";

  /// Directions with density cos / pi, so what is left to average is what they see. Where one
  /// meets the wall's plane, it does so at z = distance w.z / w.x.
  double operator()(Sampler& sampler) const {
    const Vector w = cosine_direction(sampler.next2());
    return w.x > 0 && distance * w.z < height * w.x ? 0 : 1;
  }
};

}  // namespace mc::scenes
