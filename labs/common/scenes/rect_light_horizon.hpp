#pragma once
// The irradiance from a vertical light that extends below the receiver's horizon. Two dimensions: a
// point on the light.

#include <algorithm>

#include "6-sampler/sampler.hpp"

namespace mc::scenes {

/// The rectangle [y0, y1] x [z0, z1] at x = distance > 0, of radiance 1. It faces the receiver,
/// which is at the origin and faces up (+z).
struct HorizonLight {
  double distance = 1, y0 = -1, y1 = 1, z0 = -0.5, z1 = 1;

  static constexpr std::string_view uses = "next2";

  /// Points below the horizon contribute nothing: the receiver's cosine z / r is negative there.
  double operator()(Sampler& sampler) const {
    const Point2 u = sampler.next2();
    const double dy = y1 - y0, dz = z1 - z0;
    const double y = y0 + dy * u.x, z = z0 + dz * u.y;
    const double r2 = distance * distance + y * y + z * z;
    return dy * dz * std::max(0.0, z) * distance / (r2 * r2);
  }
};

}  // namespace mc::scenes
