#pragma once
// The edge of a white half-plane that crosses a pixel. Two dimensions: a point in the pixel.

#include <cmath>

#include "6-sampler/sampler.hpp"

namespace mc::scenes {

/// White where a x + b y < c; a, b > 0.
struct PixelEdge {
  double a = std::cos(1.0), b = std::sin(1.0), c = 0.1 + (a + b) / 2;

  static constexpr std::string_view uses = "next2";

  double operator()(Sampler& sampler) const {
    const Point2 p = sampler.next2();
    return a * p.x + b * p.y < c ? 1 : 0;
  }
};

/// A picture of an edge that descends gently from left to right. Each pixel is filtered over the 24
/// x 24 pixels around it: otherwise only the few pixels on the edge would show any noise.
inline PixelEdge edge_picture(double width, double height, double column, double row) {
  const double a = 0.31, b = 1, filter = 24;
  const double c = 0.155 * width + 0.5 * height;
  return {filter * a, filter * b,
          c - a * (column - (filter - 1) / 2) - b * (row - (filter - 1) / 2)};
}

}  // namespace mc::scenes
