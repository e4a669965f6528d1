#pragma once
// Antialiasing, motion blur and defocus in one integral: a pixel is crossed by an edge that moves
// and is out of focus. Five dimensions: next2 for the pixel, next for the time, next2 for the lens.

#include <cmath>

#include "6-sampler/sampler.hpp"
#include "common/scenes/mappings.hpp"

namespace mc::scenes {

/// White where a x + b y + speed t + blur l < c, for (x, y) in the pixel, the time t in [0,1),
/// and the lens coordinate l in [-1,1]. a, b, speed, blur > 0.
struct PixelTimeLens {
  double a = std::cos(1.0), b = std::sin(1.0), speed = 0.4, blur = 0.35, c = 0.9;

  static constexpr std::string_view uses = "next2 next next2";

  double operator()(Sampler& sampler) const {
    const Point2 p = sampler.next2();
    const double t = sampler.next();
    const Point2 lens = in_unit_disk(sampler.next2());
    return a * p.x + b * p.y + speed * t + blur * lens.x < c ? 1 : 0;
  }
};

}  // namespace mc::scenes
