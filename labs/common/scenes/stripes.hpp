#pragma once
// Stripes on a plane that recedes to the horizon, like a zebra crossing: a pixel near the horizon
// contains many stripes. One dimension: the vertical position in the pixel.

#include <cmath>

#include "6-sampler/sampler.hpp"

namespace mc::scenes {

/// A pixel that extends from `top` to `bottom` below the horizon (0 < top < bottom). The plane's
/// depth at y is rise / y. White where floor(depth + phase) is even.
struct Stripes {
  double top = 0.01, bottom = 0.02, rise = 1, phase = 0;

  static constexpr std::string_view uses = "next";

  double operator()(Sampler& sampler) const {
    const double y = top + (bottom - top) * sampler.next();
    return std::fmod(std::floor(rise / y + phase), 2) == 0 ? 1 : 0;
  }
};

/// The plane, starting just below the horizon; the stripes are slightly oblique.
inline Stripes stripes_picture(double width, double height, double column, double row) {
  return {(row + 0.6) / height, (row + 1.6) / height, 4, 3 * (column + 0.5) / width};
}

}  // namespace mc::scenes
