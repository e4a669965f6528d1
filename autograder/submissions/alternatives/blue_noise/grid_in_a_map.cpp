// alternative: the grids of 4.7 are hash maps from a cell to its points, made for all N points at
// once, and every candidate is compared with all points of the rings that it needs
#include "blue_noise.hpp"
#define best_candidate right_best_candidate
#define poisson_disk right_poisson_disk
#include "solutions/blue_noise.cpp"

#include <algorithm>
#include <cmath>
#include <unordered_map>
#undef best_candidate
#undef poisson_disk

namespace mc {

using Cells = std::unordered_map<long, std::vector<Point2>>;

void best_candidate(std::span<double> x, std::span<double> y, double c, Rng& rng) {
  if (x.empty() || x.size() != y.size() || !(c > 0 && std::isfinite(c))) {
    return right_best_candidate(x, y, c, rng);
  }
  const long side = std::max(1L, std::lround(std::sqrt(static_cast<double>(x.size()))));
  const auto cell = [side](double u) {
    return std::min(static_cast<long>(u * static_cast<double>(side)), side - 1);
  };
  Cells cells;
  const auto nearest = [&](Point2 to) {
    double least = 1;
    for (long ring = 0; 2 * (ring - 1) <= side; ++ring) {
      const double reach = static_cast<double>(ring - 1) / static_cast<double>(side);
      if (ring > 1 && reach * reach > least) break;
      for (long i = -ring; i <= ring; ++i) {
        const bool is_edge = std::abs(i) == ring;
        for (long j = -ring; j <= ring; j += is_edge || ring == 0 ? 1 : 2 * ring) {
          const long row = ((cell(to.y) + i) % side + side) % side;
          const long column = ((cell(to.x) + j) % side + side) % side;
          const auto found = cells.find(row * side + column);
          if (found == cells.end()) continue;
          for (const Point2 p : found->second) {
            least = std::min(least, toroidal_distance_squared(to, p));
          }
        }
      }
    }
    return least;
  };
  for (std::size_t i = 0; i < x.size(); ++i) {
    double farthest = -1;
    for (double left = std::ceil(c * static_cast<double>(i)) + 1; left > 0; --left) {
      const Point2 candidate = uniform_point(rng);
      const double distance = nearest(candidate);
      if (distance > farthest) farthest = distance, x[i] = candidate.x, y[i] = candidate.y;
    }
    cells[cell(y[i]) * side + cell(x[i])].push_back({x[i], y[i]});
  }
}

/// Bridson's algorithm (2007) with 30 candidates around each point, then darts into cells that have
/// no point.
PointSet poisson_disk(double radius, Rng& rng) {
  if (!(radius >= 1e-4 && radius < 0.4)) return right_poisson_disk(radius, rng);
  const long side = static_cast<long>(std::ceil(std::numbers::sqrt2 / radius));
  const auto cell = [side](double u) { return static_cast<long>(u * static_cast<double>(side)); };
  std::unordered_map<long, Point2> taken;
  std::vector<Point2> points;
  const auto add_if_free = [&](Point2 p) {
    for (long i = -2; i <= 2; ++i) {
      for (long j = -2; j <= 2; ++j) {
        const long row = (cell(p.y) + i + side) % side, column = (cell(p.x) + j + side) % side;
        const auto other = taken.find(row * side + column);
        if (other != taken.end() && toroidal_distance_squared(p, other->second) < radius * radius) {
          return;
        }
      }
    }
    taken[cell(p.y) * side + cell(p.x)] = p;
    points.push_back(p);
  };
  add_if_free(uniform_point(rng));
  for (std::size_t active = 0; active < points.size(); ++active) {
    for (int k = 0; k < 30; ++k) {
      const double angle = 2 * std::numbers::pi * uniform(rng), u = uniform(rng);
      const double distance = radius * std::sqrt(1 + 3 * u);
      const double x = points[active].x + distance * std::cos(angle);
      const double y = points[active].y + distance * std::sin(angle);
      add_if_free({std::min(x - std::floor(x), below_one), std::min(y - std::floor(y), below_one)});
    }
  }
  for (int sweep = 0; sweep < 60; ++sweep) {
    for (long free = 0; free < side * side; ++free) {
      if (taken.contains(free)) continue;
      const auto row = static_cast<double>(free / side), column = static_cast<double>(free % side);
      add_if_free({std::min((column + uniform(rng)) / static_cast<double>(side), below_one),
                   std::min((row + uniform(rng)) / static_cast<double>(side), below_one)});
    }
  }
  return columns_of(points);
}

}  // namespace mc
