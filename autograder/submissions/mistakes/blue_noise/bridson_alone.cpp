// mistake: leaves the gaps that 30 tries around each point miss
// fails: 4.3
// hint: for a large radius one missed gap is a large part of the square
#include "blue_noise.hpp"
#define poisson_disk right_poisson_disk
#include "solutions/blue_noise.cpp"
#undef poisson_disk

namespace mc {

/// Bridson 2007, on the torus: new points around old ones, between one and two radii away.
PointSet poisson_disk(double radius, Rng& rng) {
  if (!(radius > 0 && radius >= 1e-5)) return right_poisson_disk(radius, rng);
  const auto side = std::max<std::size_t>(1, static_cast<std::size_t>(1 / radius));
  std::vector<std::vector<Point2>> cells(side * side);
  const auto cell = [&](double at) {
    return std::min(side - 1, static_cast<std::size_t>(at * static_cast<double>(side)));
  };
  const auto fits = [&](Point2 p) {
    for (std::size_t dj = 0; dj < 3; ++dj) {
      for (std::size_t di = 0; di < 3; ++di) {
        const std::size_t row = (cell(p.y) + dj + side - 1) % side;
        for (const Point2& q : cells[row * side + (cell(p.x) + di + side - 1) % side]) {
          if (toroidal_distance_squared(p, q) < radius * radius) return false;
        }
      }
    }
    return true;
  };
  std::vector<Point2> points, active;
  const auto add = [&](Point2 p) {
    cells[cell(p.y) * side + cell(p.x)].push_back(p);
    points.push_back(p);
    active.push_back(p);
  };
  add(uniform_point(rng));
  while (!active.empty()) {
    const auto i = static_cast<std::size_t>(uniform(rng) * static_cast<double>(active.size()));
    const Point2 center = active[i];
    bool found = false;
    for (int k = 0; k < 30 && !found; ++k) {
      const double away = radius * std::sqrt(1 + 3 * uniform(rng));
      const double angle = 2 * std::numbers::pi * uniform(rng);
      Point2 p{center.x + away * std::cos(angle), center.y + away * std::sin(angle)};
      p = {p.x - std::floor(p.x), p.y - std::floor(p.y)};
      found = p.x < 1 && p.y < 1 && fits(p);
      if (found) add(p);
    }
    if (!found) {
      active[i] = active.back();
      active.pop_back();
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
