#pragma once
// A pixel that the edge of something white crosses. Two dimensions: where in the pixel.

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

/// A picture of an edge that falls gently, from the left to the right. A pixel is the mean over the
/// 24 by 24 around it, or there would be next to nothing to see.
inline PixelEdge edge_picture(double width, double height, double column, double row) {
  const double a = 0.31, b = 1, filter = 24;
  const double c = 0.155 * width + 0.5 * height;
  return {filter * a, filter * b,
          c - a * (column - (filter - 1) / 2) - b * (row - (filter - 1) / 2)};
}

}  // namespace mc::scenes
