#pragma once
// The edge of a white object that is out of focus. Two dimensions: a point on the lens.

#include <cmath>

#include "6-sampler/sampler.hpp"
#include "common/scenes/mappings.hpp"

namespace mc::scenes {

/// A thin lens of radius `aperture`, focused at the distance `focus`. A point at `depth` is blurred
/// to a circle of confusion of radius aperture |depth - focus| / focus, measured in the plane of
/// the object. The object is a half-plane that ends `offset` to the right of the pixel's center.
struct DefocusEdge {
  double aperture = 0.1, focus = 2, depth = 3, offset = 0.025;

  static constexpr std::string_view uses = "next2";

  double operator()(Sampler& sampler) const {
    const Point2 lens = in_unit_disk(sampler.next2());
    return aperture * (depth - focus) / focus * lens.x < offset ? 1 : 0;
  }
};

/// An edge that recedes: near the camera at the bottom, in focus in between, and far away at the
/// top.
inline DefocusEdge defocus_picture(double width, double height, double column, double row) {
  const double up = (row + 0.5) / height;
  DefocusEdge at;
  at.aperture = 0.35;
  at.depth = 4 - 3.4 * up;
  at.offset = (0.5 + 0.12 * (0.5 - up) - (column + 0.5) / width) * 2;
  return at;
}

}  // namespace mc::scenes
