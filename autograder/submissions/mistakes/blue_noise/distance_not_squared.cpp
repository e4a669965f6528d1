// mistake: returns the distance, not its square
// caught by: 4.1 the distance to the nearest copy
// hint: this is the distance: its square is asked for
#include "blue_noise.hpp"
#define toroidal_distance_squared right_toroidal_distance_squared
#include "solutions/blue_noise.cpp"
#undef toroidal_distance_squared

namespace mc {

double toroidal_distance_squared(Point2 a, Point2 b) {
  return std::sqrt(right_toroidal_distance_squared(a, b));
}

}  // namespace mc
