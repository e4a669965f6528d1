// mistake: compares each dart with all points
// caught by: 4.7 the cost of Poisson disks is linear in their number
// hint: each new point is compared with all others
// limit: time
#include "blue_noise.hpp"
#define poisson_disk right_poisson_disk
#include "solutions/blue_noise.cpp"
#undef poisson_disk

namespace mc {

// The right points, after looking at all pairs of them for every try that made them.
PointSet poisson_disk(double radius, Rng& rng) {
  PointSet points = right_poisson_disk(radius, rng);
  const auto x = points.column(0), y = points.column(1);
  double closest = 1;
  for (std::size_t i = 0; i < x.size(); ++i) {
    for (std::size_t tries = 0; tries < 30; ++tries) {
      for (std::size_t p = 0; p < x.size(); ++p) {
        if (p != i) {
          closest = std::min(closest, toroidal_distance_squared({x[i], y[i]}, {x[p], y[p]}));
        }
      }
    }
  }
  if (x.size() > 1 && closest < radius * radius / 2) x[0] = 0;
  return points;
}

}  // namespace mc
