#pragma once
// The irradiance from a disk light. Two dimensions: a point on the light.

#include <numbers>

#include "6-sampler/sampler.hpp"
#include "common/scenes/mappings.hpp"

namespace mc::scenes {

/// A disk of radiance 1, parallel to the receiver. Its center is at `height` > 0 above the
/// receiver's plane, and `offset` to the side.
struct DiskLight {
  double radius = 0.75, height = 1, offset = 0;

  static constexpr std::string_view uses = "next2";

  double operator()(Sampler& sampler) const {
    const Point2 p = in_unit_disk(sampler.next2());
    const double x = offset + radius * p.x, y = radius * p.y, h = height;
    const double r2 = x * x + y * y + h * h;
    return std::numbers::pi * radius * radius * (h * h) / (r2 * r2);
  }
};

}  // namespace mc::scenes
