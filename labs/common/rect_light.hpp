#pragma once

namespace mc {

/// A rectangle [x0, x1] x [y0, y1] at z = `height` > 0 that emits `radiance` downward, equally in
/// all directions. The receiver is at the origin, in the plane z = 0, and faces up.
struct RectLight {
  double x0 = -1, x1 = 1, y0 = -0.5, y1 = 0.5;
  double height = 1;
  double radiance = 1;  ///< W/(m^2 sr)
};

}  // namespace mc
