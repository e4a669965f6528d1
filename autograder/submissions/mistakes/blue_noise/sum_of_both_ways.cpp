// mistake: adds the two ways, not their squares
// caught by: 4.1 the distance to the nearest copy
// hint: this is the sum of both ways
#include "blue_noise.hpp"
#define toroidal_distance_squared right_toroidal_distance_squared
#include "solutions/blue_noise.cpp"
#undef toroidal_distance_squared

namespace mc {

double toroidal_distance_squared(Point2 a, Point2 b) {
  const double dx = std::abs(a.x - b.x), dy = std::abs(a.y - b.y);
  return std::min(dx, 1 - dx) + std::min(dy, 1 - dy);
}

}  // namespace mc
