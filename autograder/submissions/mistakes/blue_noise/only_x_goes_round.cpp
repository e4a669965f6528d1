// mistake: goes round the torus along x and forgets y
// caught by: 4.1 the distance to the nearest copy
// hint: x goes round the torus, y does not
#include "blue_noise.hpp"
#define toroidal_distance_squared right_toroidal_distance_squared
#include "solutions/blue_noise.cpp"
#undef toroidal_distance_squared

namespace mc {

double toroidal_distance_squared(Point2 a, Point2 b) {
  double dx = std::abs(a.x - b.x);
  dx = std::min(dx, 1 - dx);
  return dx * dx + (a.y - b.y) * (a.y - b.y);
}

}  // namespace mc
