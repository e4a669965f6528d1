#pragma once
// The irradiance from a rectangular light. Two dimensions: a point on the light.

#include "6-sampler/sampler.hpp"
#include "common/rect_light.hpp"

namespace mc::scenes {

struct RectangleLight {
  RectLight light;

  static constexpr std::string_view uses = "next2";

  /// Area times radiance times both cosines over r^2. Each cosine, at receiver and light, is
  /// height / r.
  double operator()(Sampler& sampler) const {
    const Point2 u = sampler.next2();
    const double dx = light.x1 - light.x0, dy = light.y1 - light.y0;
    const double x = light.x0 + dx * u.x, y = light.y0 + dy * u.y, h = light.height;
    const double r2 = x * x + y * y + h * h;
    return dx * dy * light.radiance * (h * h) / (r2 * r2);
  }
};

}  // namespace mc::scenes
