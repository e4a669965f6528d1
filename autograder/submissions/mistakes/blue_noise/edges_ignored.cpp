// mistake: keeps the distance within the square, and not across its edges
// caught by: 4.3 no two points are closer
// caught by: 4.3 the pattern is nearly maximal
// caught by: 4.3 Poisson disks are blue
// caught by: 4.3 a radius too large
// hint: close only across an edge
#include "blue_noise.hpp"
#define poisson_disk right_poisson_disk
#include "solutions/blue_noise.cpp"
#undef poisson_disk

namespace mc {

PointSet poisson_disk(double radius, Rng& rng) {
  if (!(radius > 0 && radius >= 1e-5)) return right_poisson_disk(radius, rng);
  std::vector<Point2> points;
  const auto fits = [&](Point2 dart) {
    for (const Point2& p : points) {
      if (std::hypot(dart.x - p.x, dart.y - p.y) < radius) return false;
    }
    return true;
  };
  for (int misses = 0; misses < 100;) {
    const Point2 dart = uniform_point(rng);
    if (fits(dart)) {
      points.push_back(dart);
      misses = 0;
    } else {
      ++misses;
    }
  }
  PointSet set(points.size(), 2);
  for (std::size_t i = 0; i < points.size(); ++i) {
    set.column(0)[i] = points[i].x;
    set.column(1)[i] = points[i].y;
  }
  return set;
}

}  // namespace mc
