// alternative: Bridson's algorithm with 30 tries per point, then darts into what it has left
#include "blue_noise.hpp"
#define poisson_disk right_poisson_disk
#include "solutions/blue_noise.cpp"

#include <algorithm>
#include <cmath>
#undef poisson_disk

namespace mc {

// Free choices.
constexpr int tries = 30;
constexpr std::size_t darts_per_point = 60;

/// The points of the square in cells at least as wide as the radius.
struct Cells {
  double radius;
  std::size_t side = std::max<std::size_t>(1, static_cast<std::size_t>(1 / radius));
  std::vector<std::vector<Point2>> points{side * side};

  std::vector<Point2>& at(Point2 p, std::size_t right = 0, std::size_t up = 0) {
    const auto cell = [&](double place) {
      return static_cast<std::size_t>(place * static_cast<double>(side));
    };
    return points[(cell(p.y) + up) % side * side + (cell(p.x) + right) % side];
  }
  bool fits(Point2 p) {
    for (const std::size_t up : {side - 1, side, side + 1}) {
      for (const std::size_t right : {side - 1, side, side + 1}) {
        for (const Point2& q : at(p, right, up)) {
          if (toroidal_distance_squared(p, q) < radius * radius) return false;
        }
      }
    }
    return true;
  }
};

/// Between one and two radii away from a point, on the torus.
Point2 near(Point2 center, double radius, Rng& rng) {
  const double away = radius * std::sqrt(1 + 3 * uniform(rng));
  const double angle = 2 * std::numbers::pi * uniform(rng);
  const double x = center.x + away * std::cos(angle), y = center.y + away * std::sin(angle);
  return {std::min(x - std::floor(x), below_one), std::min(y - std::floor(y), below_one)};
}

/// Bridson 2007: new points around old ones.
PointSet poisson_disk(double radius, Rng& rng) {
  if (!(radius >= 1e-5)) return right_poisson_disk(radius, rng);
  radius = std::min(radius, 1.0);
  Cells cells{radius};
  std::vector<Point2> points{uniform_point(rng)}, active = points;
  cells.at(points[0]).push_back(points[0]);
  const auto added = [&](Point2 p) {
    if (!cells.fits(p)) return false;
    cells.at(p).push_back(p);
    points.push_back(p);
    active.push_back(p);
    return true;
  };
  while (!active.empty()) {
    const std::size_t i = rng() % active.size();
    bool found = false;
    for (int left = tries; left > 0 && !found; --left) found = added(near(active[i], radius, rng));
    if (found) continue;
    active[i] = active.back();
    active.pop_back();
  }
  // What the rings have missed. Each point that is found adds its share of darts.
  for (std::size_t darts = 0; darts < 1000 + darts_per_point * points.size(); ++darts) {
    added(uniform_point(rng));
  }
  return columns_of(points);
}

}  // namespace mc
