#pragma once
// The irradiance in the penumbra of a straight edge. Two dimensions: a point on the light.

#include "6-sampler/sampler.hpp"
#include "common/rect_light.hpp"

namespace mc::scenes {

/// A rectangular light above a receiver at (receiver, 0, 0). An opaque half-plane x > edge at
/// z = height blocks part of the light.
struct HalfplanePenumbra {
  RectLight light;
  double receiver = 0.1, edge = 0.2, height = 0.5;

  static constexpr std::string_view uses = "next2";

  double operator()(Sampler& sampler) const {
    const Point2 u = sampler.next2();
    const double dx = light.x1 - light.x0, dy = light.y1 - light.y0, h = light.height;
    const double x = light.x0 + dx * u.x - receiver, y = light.y0 + dy * u.y;
    if (receiver + x * height / h > edge) return 0;
    const double r2 = x * x + y * y + h * h;
    return dx * dy * light.radiance * (h * h) / (r2 * r2);
  }
};

/// A floor under the light, half of it in the shadow of a table. A pixel shows the irradiance at
/// its center.
inline HalfplanePenumbra penumbra_picture(double width, double height, double column, double row) {
  const double scale = 3 / width;
  const double y = scale * (row + 0.5 - height / 2);
  HalfplanePenumbra at{{-1, 1, -0.5 - y, 0.5 - y, 1, 1}, scale * (column + 0.5 - width / 2)};
  at.edge = 0.1 + 0.2 * y;  // not parallel to the columns of pixels
  return at;
}

}  // namespace mc::scenes
