#pragma once
// An edge that moves across a pixel while the shutter is open. Two unrelated dimensions, so two
// calls of next(): the position in the pixel across the edge, and the time.

#include "6-sampler/sampler.hpp"

namespace mc::scenes {

/// White where x < start + speed t, for x and t in [0,1).
struct MotionEdge {
  double start = 0.2, speed = 1.3;

  static constexpr std::string_view uses = "next next";

  double operator()(Sampler& sampler) const {
    const double x = sampler.next();
    const double t = sampler.next();
    return x < start + speed * t ? 1 : 0;
  }
};

/// Edges that all start at the same column and move faster toward the bottom of the picture.
inline MotionEdge motion_picture(double width, double height, double column, double row) {
  return {0.2 * width + 0.31 - column, 0.6 * width * (row + 0.5) / height};
}

}  // namespace mc::scenes
