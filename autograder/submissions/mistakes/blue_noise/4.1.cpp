// Mistakes in task 4.1.
#include "blue_noise.hpp"

#define toroidal_distance_squared right_toroidal_distance_squared
#include "solutions/blue_noise.cpp"
#undef toroidal_distance_squared

// mistake: returns the distance, not its square
// hint: this is the distance: the task asks for its square
namespace mc::distance_not_squared {
double toroidal_distance_squared(Point2 a, Point2 b) {
  return std::sqrt(right_toroidal_distance_squared(a, b));
}
}  // namespace mc::distance_not_squared

// mistake: wraps around the torus along x but not along y
// hint: x wraps around the torus, y does not
namespace mc::only_x_goes_round {
double toroidal_distance_squared(Point2 a, Point2 b) {
  double dx = std::abs(a.x - b.x);
  dx = std::min(dx, 1 - dx);
  return dx * dx + (a.y - b.y) * (a.y - b.y);
}
}  // namespace mc::only_x_goes_round

// mistake: adds the two coordinate differences, not their squares
// hint: this is |dx| + |dy|
namespace mc::sum_of_both_ways {
double toroidal_distance_squared(Point2 a, Point2 b) {
  const double dx = std::abs(a.x - b.x), dy = std::abs(a.y - b.y);
  return std::min(dx, 1 - dx) + std::min(dy, 1 - dy);
}
}  // namespace mc::sum_of_both_ways

// mistake: measures distances within the square, not on the torus
// hint: the distance across an edge is shorter
namespace mc::within_the_square {
double toroidal_distance_squared(Point2 a, Point2 b) {
  return (a.x - b.x) * (a.x - b.x) + (a.y - b.y) * (a.y - b.y);
}
}  // namespace mc::within_the_square
