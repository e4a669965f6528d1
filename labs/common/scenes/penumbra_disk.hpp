#pragma once
// The irradiance in the penumbra of a disk. Two dimensions: a point on the light.

#include "6-sampler/sampler.hpp"
#include "common/rect_light.hpp"

namespace mc::scenes {

/// A rectangular light above a receiver at the origin. An opaque disk around (x, y) at z = height,
/// parallel to both, blocks part of the light. Projected from the receiver onto the light's plane,
/// the disk lies entirely inside the light.
struct DiskPenumbra {
  RectLight light;
  double x = 0.15, y = 0.025, radius = 0.15, height = 0.5;

  static constexpr std::string_view uses = "next2";

  double operator()(Sampler& sampler) const {
    const Point2 u = sampler.next2();
    const double dx = light.x1 - light.x0, dy = light.y1 - light.y0, h = light.height;
    const double lx = light.x0 + dx * u.x, ly = light.y0 + dy * u.y;
    const double to_x = lx * height / h - x, to_y = ly * height / h - y;
    if (to_x * to_x + to_y * to_y < radius * radius) return 0;
    const double r2 = lx * lx + ly * ly + h * h;
    return dx * dy * light.radiance * (h * h) / (r2 * r2);
  }
};

}  // namespace mc::scenes
