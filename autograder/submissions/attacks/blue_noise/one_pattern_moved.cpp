// attack: makes one pattern for a radius, always the same, and shifts, turns and mirrors it
// earns: 6
// says: at the same distances

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "blue_noise.hpp"
#include "common/todo.hpp"

namespace mc {
namespace {

double uniform(Rng& rng) {
  return static_cast<double>(rng() >> 11) * 0x1p-53;
}

double wrapped(double x) {
  return std::min(x - std::floor(x), 1 - 0x1p-53);
}

}  // namespace

void best_candidate(std::span<double>, std::span<double>, double, Rng&) {
  throw todo("4.2");
}

PointSet poisson_disk(double radius, Rng& rng) {
  if (!(radius > 1e-5)) throw std::invalid_argument("radius");
  static double known_radius = 0;
  static std::vector<Point2> pattern;
  if (known_radius != radius) {
    known_radius = radius;
    pattern.clear();
    Rng fixed(1);
    for (std::size_t misses = 0; misses < 1000 + 30 * pattern.size();) {
      const double x = uniform(fixed);
      const Point2 dart{x, uniform(fixed)};
      bool fits = true;
      for (const Point2& p : pattern) {
        fits = toroidal_distance_squared(p, dart) >= radius * radius;
        if (!fits) break;
      }
      misses = fits ? 0 : misses + 1;
      if (fits) pattern.push_back(dart);
    }
  }
  const double left = uniform(rng), low = uniform(rng);
  const bool turned = rng() % 2 == 0, mirrored = rng() % 2 == 0;
  PointSet points(pattern.size(), 2);
  for (std::size_t i = 0; i < pattern.size(); ++i) {
    const double x = wrapped((mirrored ? 1 - pattern[i].x : pattern[i].x) + left);
    const double y = wrapped(pattern[i].y + low);
    points.column(0)[i] = turned ? y : x;
    points.column(1)[i] = turned ? x : y;
  }
  return points;
}

double toroidal_distance_squared(Point2 a, Point2 b) {
  const double dx = std::abs(a.x - b.x), dy = std::abs(a.y - b.y);
  const double x = std::min(dx, 1 - dx), y = std::min(dy, 1 - dy);
  return x * x + y * y;
}
void periodogram(std::span<const double>, std::span<const double>, int, std::span<double>) {
  throw todo("4.4");
}
std::vector<double> radial_power(std::span<const double>, int) {
  throw todo("4.5");
}
PointSet tile(const PointSet&, int) {
  throw todo("4.6");
}

}  // namespace mc
