// Mistakes in task 4.3.
#include "blue_noise.hpp"

#define poisson_disk right_poisson_disk
#include "solutions/blue_noise.cpp"
#undef poisson_disk

namespace mc {
namespace {

constexpr double least_radius = 1e-5;

/// Darts until `misses` in a row are nearer to a point than the radius.
template <class DistanceSquared>
PointSet darts(double radius, Rng& rng, int misses, DistanceSquared distance_squared) {
  if (!(radius >= least_radius)) return right_poisson_disk(radius, rng);
  std::vector<Point2> points;
  for (int missed = 0; missed < misses;) {
    const Point2 dart = uniform_point(rng);
    const bool fits = std::all_of(points.begin(), points.end(), [&](Point2 p) {
      return distance_squared(dart, p) >= radius * radius;
    });
    if (fits) points.push_back(dart);
    missed = fits ? 0 : missed + 1;
  }
  return columns_of(points);
}

/// Darts on a grid of side x side cells that store one point each; `reach` cells on each side are
/// searched. Ends after misses(number of points) in a row.
template <class Misses>
PointSet darts_on_grid(double radius, Rng& rng, double cells_per_side, int reach, Misses misses,
                       std::vector<Point2> first = {}) {
  if (!(radius >= least_radius)) return right_poisson_disk(radius, rng);
  const int side = std::max(1, static_cast<int>(cells_per_side));
  std::vector<Point2> cells(static_cast<std::size_t>(side) * side, Point2{-1, -1}), points;
  const auto cell = [&](int column, int row) -> Point2& {
    const int i = (column % side + side) % side, j = (row % side + side) % side;
    return cells[static_cast<std::size_t>(j) * side + i];
  };
  for (std::size_t missed = 0; missed < misses(points.size());) {
    const Point2 dart = points.size() < first.size() ? first[points.size()] : uniform_point(rng);
    const int column = static_cast<int>(dart.x * side), row = static_cast<int>(dart.y * side);
    bool fits = true;
    for (int dj = -reach; dj <= reach; ++dj) {
      for (int di = -reach; di <= reach; ++di) {
        const Point2& near = cell(column + di, row + dj);
        fits = fits && (near.x < 0 || toroidal_distance_squared(dart, near) >= radius * radius);
      }
    }
    missed = fits ? 0 : missed + 1;
    if (!fits) continue;
    // A cell that forgets a point has room for ever.
    if (static_cast<double>(points.size()) > 2 / radius / radius) break;
    cell(column, row) = dart;
    points.push_back(dart);
  }
  return columns_of(points);
}

std::size_t enough_misses(std::size_t points) {
  return 1000 + 30 * points;
}

/// Bridson 2007, on the torus: `tries` new points around each old one, at distances away().
struct Bridson {
  double radius;
  Rng& rng;
  std::size_t side = std::max<std::size_t>(1, static_cast<std::size_t>(1 / radius));
  std::vector<std::vector<Point2>> cells{side * side};
  std::vector<Point2> points{}, active{};

  std::size_t cell(double at) const {
    return std::min(side - 1, static_cast<std::size_t>(at * static_cast<double>(side)));
  }
  bool fits(Point2 p) const {
    for (std::size_t dj = 0; dj < 3; ++dj) {
      for (std::size_t di = 0; di < 3; ++di) {
        const std::size_t row = (cell(p.y) + dj + side - 1) % side;
        for (const Point2& q : cells[row * side + (cell(p.x) + di + side - 1) % side]) {
          if (toroidal_distance_squared(p, q) < radius * radius) return false;
        }
      }
    }
    return true;
  }
  void add(Point2 p) {
    cells[cell(p.y) * side + cell(p.x)].push_back(p);
    points.push_back(p);
    active.push_back(p);
  }
  template <class Away>
  void fill(int tries, Away away) {
    add(uniform_point(rng));
    while (!active.empty()) {
      const auto i = static_cast<std::size_t>(uniform(rng) * static_cast<double>(active.size()));
      const Point2 center = active[i];
      bool found = false;
      for (int k = 0; k < tries && !found; ++k) {
        const double distance = away();
        const double angle = 2 * std::numbers::pi * uniform(rng);
        Point2 p{center.x + distance * std::cos(angle), center.y + distance * std::sin(angle)};
        p = {p.x - std::floor(p.x), p.y - std::floor(p.y)};
        found = p.x < 1 && p.y < 1 && fits(p);
        if (found) add(p);
      }
      if (!found) {
        active[i] = active.back();
        active.pop_back();
      }
    }
  }
};

}  // namespace
}  // namespace mc

#define POISSON_DISK(...)                          \
  PointSet poisson_disk(double radius, Rng& rng) { \
    return __VA_ARGS__;                            \
  }

// mistake: places new points only on the edge of an existing disk
// hint: not only on rims of disks
namespace mc::at_the_rim {
PointSet poisson_disk(double radius, Rng& rng) {
  if (!(radius >= least_radius)) return right_poisson_disk(radius, rng);
  Bridson pattern{radius, rng};
  pattern.fill(300, [&] { return radius * (1 + 1e-9); });
  return columns_of(pattern.points);
}
}  // namespace mc::at_the_rim

// mistake: rounds the number of cells down, so a cell can hold two points but stores only the last
// hint: must not have room for two
namespace mc::cells_rounded_down {
POISSON_DISK(darts_on_grid(radius, rng, std::numbers::sqrt2 / radius, 2, enough_misses))
}  // namespace mc::cells_rounded_down

// mistake: measures the distance within the square, not across its edges
// hint: close only across an edge
namespace mc::edges_ignored {
double distance_squared(Point2 a, Point2 b) {
  return (a.x - b.x) * (a.x - b.x) + (a.y - b.y) * (a.y - b.y);
}
POISSON_DISK(darts(radius, rng, 100, distance_squared))
}  // namespace mc::edges_ignored

// mistake: searches the eight cells around a point, in a grid whose cells are too narrow for that
// hint: compare each new point with all points near it
namespace mc::eight_cells_around {
POISSON_DISK(darts_on_grid(radius, rng, std::ceil(std::numbers::sqrt2 / radius), 1, enough_misses))
}  // namespace mc::eight_cells_around

// mistake: fills the square with four copies of a pattern of twice the radius
// hint: copies of a pattern
namespace mc::four_copies {
PointSet poisson_disk(double radius, Rng& rng) {
  if (!(radius >= least_radius && radius < 0.07)) return right_poisson_disk(radius, rng);
  return tile(right_poisson_disk(2 * radius, rng), 2);
}
}  // namespace mc::four_copies

// mistake: starts each pattern in the middle of the square
// hint: the first point of a set must be random, too
namespace mc::first_point_in_the_middle {
PointSet poisson_disk(double radius, Rng& rng) {
  return darts_on_grid(radius, rng, std::ceil(std::numbers::sqrt2 / radius), 2,
                       [](std::size_t points) { return 1000 + enough_misses(points); },
                       {{0.5, 0.5}});
}
}  // namespace mc::first_point_in_the_middle

// mistake: draws from a copy of the generator, so every pattern is the same
// hint: draw every point from the generator that is passed in
namespace mc::generator_of_its_own {
PointSet poisson_disk(double radius, Rng& rng) {
  Rng copy = rng;
  return right_poisson_disk(radius, copy);
}
}  // namespace mc::generator_of_its_own

// mistake: throws darts until 300 in a row miss
// hint: a number of misses in a row does not prove
namespace mc::three_hundred_misses {
POISSON_DISK(darts(radius, rng, 300, toroidal_distance_squared))
}  // namespace mc::three_hundred_misses

// mistake: takes the radius for that of disks that may touch, so points are too close
// hint: half the radius is kept
namespace mc::half_the_radius {
POISSON_DISK(right_poisson_disk(radius >= 2e-5 ? radius / 2 : radius, rng))
}  // namespace mc::half_the_radius

// mistake: starts with a radius whose pattern does not fit into memory
// hint: a message with the number of points
namespace mc::silent_about_memory {
PointSet poisson_disk(double radius, Rng& rng) {
  if (radius < 1e-5) throw std::invalid_argument("radius: too small");
  return right_poisson_disk(radius, rng);
}
}  // namespace mc::silent_about_memory
