// Mistakes in task 4.7.
#define best_candidate right_best_candidate
#include "autograder/submissions/mistakes/blue_noise/4.3.cpp"
#undef best_candidate

#define DARTS_ON_GRID(misses)                                                         \
  POISSON_DISK(darts_on_grid(radius, rng, std::ceil(std::numbers::sqrt2 / radius), 2, \
                             [](std::size_t points) -> std::size_t { return misses; }))

// mistake: compares a candidate until one point is too near: a third of the work, still quadratic
// hint: compare a candidate only with points nearby
namespace mc::compares_until_too_near {
void best_candidate(std::span<double> x, std::span<double> y, double c, Rng& rng) {
  require_pairs(x.size(), y.size());
  if (!(c > 0 && std::isfinite(c))) throw std::invalid_argument("c: must be positive and finite");
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double candidates = std::ceil(c * static_cast<double>(i)) + 1;
    double best = -1;
    for (double k = 0; k < candidates; ++k) {
      const Point2 candidate = uniform_point(rng);
      double nearest = 1;
      for (std::size_t p = 0; p < i && nearest > best; ++p) {
        nearest = std::min(nearest, toroidal_distance_squared(candidate, {x[p], y[p]}));
      }
      if (nearest <= best) continue;
      best = nearest;
      x[i] = candidate.x;
      y[i] = candidate.y;
    }
  }
}
}  // namespace mc::compares_until_too_near

// mistake: searches the nine cells around a candidate, of a grid for all points: the nearest of few
// points is farther away
// hint: search all cells that can contain it
namespace mc::nine_cells_only {
void best_candidate(std::span<double> x, std::span<double> y, double c, Rng& rng) {
  require_pairs(x.size(), y.size());
  if (!(c > 0 && std::isfinite(c))) throw std::invalid_argument("c: must be positive and finite");
  if (x.size() < 1024) return right_best_candidate(x, y, c, rng);
  const auto side = static_cast<std::size_t>(std::sqrt(x.size() / 4.0));
  std::vector<std::vector<std::size_t>> cells(side * side);
  const auto cell = [&](double at) {
    return static_cast<std::size_t>(at * static_cast<double>(side));
  };
  for (std::size_t i = 0; i < x.size(); ++i) {
    double best = -1;
    for (double k = 0; k < std::ceil(c * static_cast<double>(i)) + 1; ++k) {
      const Point2 candidate = uniform_point(rng);
      double nearest = 1;
      for (std::size_t near = 0; near < 9; ++near) {
        const std::size_t column = (cell(candidate.x) + side + near % 3 - 1) % side;
        const std::size_t row = (cell(candidate.y) + side + near / 3 - 1) % side;
        for (const std::size_t p : cells[row * side + column]) {
          nearest = std::min(nearest, toroidal_distance_squared(candidate, {x[p], y[p]}));
        }
      }
      if (nearest <= best) continue;
      best = nearest;
      x[i] = candidate.x;
      y[i] = candidate.y;
    }
    cells[cell(y[i]) * side + cell(x[i])].push_back(i);
  }
}
}  // namespace mc::nine_cells_only

// mistake: compares each dart with all points
// hint: compare a new point only with those in the cells around it
namespace mc::darts_compared_with_all {
// The right points, after looking at all pairs of them for every try that made them.
PointSet poisson_disk(double radius, Rng& rng) {
  PointSet points = right_poisson_disk(radius, rng);
  const auto x = points.column(0), y = points.column(1);
  double closest = 1;
  for (std::size_t i = 0; i < 30 * x.size(); ++i) {
    for (std::size_t p = 0, q = i % x.size(); p < x.size(); ++p) {
      if (p != q)
        closest = std::min(closest, toroidal_distance_squared({x[q], y[q]}, {x[p], y[p]}));
    }
  }
  if (x.size() > 1 && closest < radius * radius / 2) x[0] = 0;
  return points;
}
}  // namespace mc::darts_compared_with_all

// mistake: throws darts until as many have missed in a row as there are pairs of points
// hint: do not fill the last gaps by darts at the whole square
namespace mc::darts_for_each_pair {
DARTS_ON_GRID(1000 + points * points)
}  // namespace mc::darts_for_each_pair

// mistake: throws darts until 1,000 in a row miss: enough for some hundred points only
// hint: the number of tries must grow with the number of points
namespace mc::stops_after_a_thousand_misses {
DARTS_ON_GRID(points > 0 ? 1000 : 1)
}  // namespace mc::stops_after_a_thousand_misses
