#pragma once
// Stripes across a plane that runs into depth, as a zebra crossing: toward the horizon a pixel has
// many of them. One dimension: how far down in the pixel.

#include <cmath>

#include "6-sampler/sampler.hpp"

namespace mc::scenes {

/// A pixel between `top` and `bottom` below the horizon (0 < top < bottom), where the plane's depth
/// is rise / y. White where floor(depth + phase) is even.
struct Stripes {
  double top = 0.01, bottom = 0.02, rise = 1, phase = 0;

  static constexpr std::string_view uses = "next";

  double operator()(Sampler& sampler) const {
    const double y = top + (bottom - top) * sampler.next();
    return std::fmod(std::floor(rise / y + phase), 2) == 0 ? 1 : 0;
  }
};

/// The plane from just below its horizon, the stripes a little askew.
inline Stripes stripes_picture(double width, double height, double column, double row) {
  return {(row + 0.6) / height, (row + 1.6) / height, 4, 3 * (column + 0.5) / width};
}

}  // namespace mc::scenes
