// alternative: candidates are drawn first, and each is compared with the points in a fixed grid,
// ring by ring
#include "blue_noise.hpp"
#define best_candidate right_best_candidate
#include "solutions/blue_noise.cpp"

#include <algorithm>
#include <cmath>
#undef best_candidate

namespace mc {

constexpr double points_per_cell = 2;  // a free choice

void best_candidate(std::span<double> x, std::span<double> y, double c, Rng& rng) {
  require_pairs(x.size(), y.size());
  if (!(c > 0 && std::isfinite(c))) throw std::invalid_argument("c: must be positive and finite");
  const int side =
      static_cast<int>(std::ceil(std::sqrt(static_cast<double>(x.size()) / points_per_cell)));
  std::vector<std::vector<Point2>> cells(static_cast<std::size_t>(side * side));
  const auto cell = [&](int i, int j) -> std::vector<Point2>& {
    return cells[static_cast<std::size_t>((j + side) % side * side + (i + side) % side)];
  };
  const auto nearest = [&](Point2 p, double enough) {
    const int i = static_cast<int>(p.x * side), j = static_cast<int>(p.y * side);
    double least = 1;
    for (int ring = 0; ring <= side / 2; ++ring) {
      for (int row = j - ring; row <= j + ring; ++row) {
        for (int column = i - ring; column <= i + ring; ++column) {
          if (std::max(std::abs(row - j), std::abs(column - i)) < ring) continue;  // seen before
          for (const Point2& q : cell(column, row)) {
            least = std::min(least, toroidal_distance_squared(p, q));
          }
        }
      }
      if (least < enough || least <= static_cast<double>(ring * ring) / (side * side)) break;
    }
    return least;
  };
  std::vector<Point2> candidates;
  for (std::size_t i = 0; i < x.size(); ++i) {
    candidates.resize(static_cast<std::size_t>(std::ceil(c * static_cast<double>(i))) + 1);
    for (Point2& candidate : candidates) candidate.y = uniform(rng);
    for (Point2& candidate : candidates) candidate.x = uniform(rng);
    double farthest = -1;
    Point2 best;
    for (auto candidate = candidates.rbegin(); candidate != candidates.rend(); ++candidate) {
      const double here = nearest(*candidate, farthest);
      if (here <= farthest) continue;
      farthest = here;
      best = *candidate;
    }
    cell(static_cast<int>(best.x * side), static_cast<int>(best.y * side)).push_back(best);
    x[i] = best.x;
    y[i] = best.y;
  }
}

}  // namespace mc
