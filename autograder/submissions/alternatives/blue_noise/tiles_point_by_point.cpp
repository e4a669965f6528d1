// alternative: tiles point by point, each coordinate held below the edge of its own cell; distances
// by rounding
#include "blue_noise.hpp"
#define tile right_tile
#define toroidal_distance_squared right_toroidal_distance_squared
#include "solutions/blue_noise.cpp"

#include <algorithm>
#undef tile
#undef toroidal_distance_squared

namespace mc {

double toroidal_distance_squared(Point2 a, Point2 b) {
  const double dx = a.x - b.x, dy = a.y - b.y;
  const double x = dx - std::round(dx), y = dy - std::round(dy);
  return x * x + y * y;
}

PointSet tile(const PointSet& pattern, int copies) {
  if (copies < 1) throw std::invalid_argument("copies must be positive");
  if (pattern.dims() != 2 || pattern.size() == 0) {
    throw std::invalid_argument("pattern must hold points of the plane");
  }
  const double width = 1.0 / copies;
  const auto place = [&](int cell, double x) {
    return std::min((cell + x) * width, std::nextafter((cell + 1) * width, 0.0));
  };
  const auto repeats = static_cast<std::size_t>(copies);
  PointSet tiled(pattern.size() * repeats * repeats, 2);
  std::size_t i = 0;
  for (std::size_t p = 0; p < pattern.size(); ++p) {
    for (int column = 0; column < copies; ++column) {
      for (int row = copies - 1; row >= 0; --row, ++i) {
        tiled.column(0)[i] = place(column, pattern.column(0)[p]);
        tiled.column(1)[i] = place(row, pattern.column(1)[p]);
      }
    }
  }
  return tiled;
}

}  // namespace mc
