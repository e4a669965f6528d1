// What a pattern can cost the judge. Sections: see CONTRIBUTING.md.

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <vector>

#include "blue_noise.hpp"

namespace mc {

inline double uniform(Rng& rng) {
  return static_cast<double>(rng() >> 11) * 0x1p-53;
}

double toroidal_distance_squared(Point2 a, Point2 b) {
  const double dx = std::abs(a.x - b.x), dy = std::abs(a.y - b.y);
  const double x = std::min(dx, 1 - dx), y = std::min(dy, 1 - dy);
  return x * x + y * y;
}

}  // namespace mc

//// many_disks
// attack: returns 900,000 points where one or two fit, to cost the judge memory and time
// earns: 26
// says: gave 450000 values in x

namespace mc {
PointSet poisson_disk(double radius, Rng& rng) {
  if (!(radius > 1e-5)) throw std::invalid_argument("radius");
  if (radius > 0.6) return PointSet(4500, 2);
  std::vector<Point2> pattern;
  for (std::size_t misses = 0; misses < 1000 + 30 * pattern.size();) {
    const double x = uniform(rng);
    const Point2 dart{x, uniform(rng)};
    bool fits = true;
    for (const Point2& p : pattern) {
      fits = toroidal_distance_squared(p, dart) >= radius * radius;
      if (!fits) break;
    }
    misses = fits ? 0 : misses + 1;
    if (fits) pattern.push_back(dart);
  }
  PointSet points(pattern.size(), 2);
  for (std::size_t i = 0; i < pattern.size(); ++i) {
    points.column(0)[i] = pattern[i].x;
    points.column(1)[i] = pattern[i].y;
  }
  return points;
}
}  // namespace mc
