// Patterns that are none. Sections: see CONTRIBUTING.md.

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "blue_noise.hpp"

namespace mc {

inline double uniform(Rng& rng) {
  return static_cast<double>(rng() >> 11) * 0x1p-53;
}

inline double below_one(double x) {
  return std::min(x - std::floor(x), 1 - 0x1p-53);
}

double toroidal_distance_squared(Point2 a, Point2 b) {
  const double dx = std::abs(a.x - b.x), dy = std::abs(a.y - b.y);
  const double x = std::min(dx, 1 - dx), y = std::min(dy, 1 - dy);
  return x * x + y * y;
}

/// A lattice of columns and rows, moved at random as a whole, or each row on its own.
inline void fill_lattice(std::span<double> x, std::span<double> y, double c, bool by_rows,
                         Rng& rng) {
  if (x.size() != y.size()) throw std::invalid_argument("x and y");
  if (x.empty()) throw std::invalid_argument("x");
  if (!(c > 0 && std::isfinite(c))) throw std::invalid_argument("c");
  const auto side = static_cast<std::size_t>(std::ceil(std::sqrt(static_cast<double>(x.size()))));
  const double low = uniform(rng);
  double left = uniform(rng);
  for (std::size_t i = 0; i < x.size(); ++i) {
    if (by_rows && i % side == 0) left = uniform(rng);
    x[i] = below_one(left + static_cast<double>(i % side) / static_cast<double>(side));
    y[i] = below_one(low + static_cast<double>(i / side) / static_cast<double>(side));
  }
}

inline PointSet lattice_of(double radius, bool by_rows, Rng& rng) {
  if (!(radius > 0)) throw std::invalid_argument("radius");
  if (radius < 1e-5) {
    throw std::invalid_argument("radius " + std::to_string(0.7 / radius / radius));
  }
  const auto side = std::max<std::size_t>(1, static_cast<std::size_t>(1 / radius));
  if (side == 1 && radius < std::sqrt(0.5)) {  // a diagonal pair
    PointSet pair(2, 2);
    pair.column(0)[0] = uniform(rng);
    pair.column(1)[0] = uniform(rng);
    for (std::size_t d = 0; d < 2; ++d) pair.column(d)[1] = below_one(pair.column(d)[0] + 0.5);
    return pair;
  }
  PointSet points(side * side, 2);
  fill_lattice(points.column(0), points.column(1), 1, by_rows, rng);
  return points;
}

}  // namespace mc

//// many_disks
// attack: returns 900,000 points where one or two fit, to cost the judge memory and time
// earns: 26
// says: gave 900000 values in x

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

//// odd_sizes
// attack: claims sizes of sets that do not add up to its points, nor to anything else
// earns: 6
// says: expected  integers in their range

#include <unistd.h>

#include "runner/wire.hpp"

namespace mc {
PointSet poisson_disk(double, Rng&) {
  wire::Writer result;
  result.put(std::vector<double>{0.25, 0.5});
  result.put(std::vector<double>{0.25, 0.5});
  std::vector<std::uint64_t> sizes(40, 1);
  sizes[1] = ~std::uint64_t{0};
  result.put(sizes);
  const wire::Header header{wire::magic, wire::Status::value, 0, result.bytes.size()};
  if (write(3, &header, sizeof header) < 0) _exit(1);
  if (write(3, result.bytes.data(), result.bytes.size()) < 0) _exit(1);
  _exit(0);
}
}  // namespace mc

//// one_pattern_moved
// attack: makes one pattern for a radius, always the same, and shifts, turns and mirrors it
// earns: 6
// says: have the same neighborhood

namespace mc {
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
    const double x = below_one((mirrored ? 1 - pattern[i].x : pattern[i].x) + left);
    const double y = below_one(pattern[i].y + low);
    points.column(0)[i] = turned ? y : x;
    points.column(1)[i] = turned ? x : y;
  }
  return points;
}
}  // namespace mc

//// one_point
// attack: one random point is every pattern
// earns: 6
// says: there is room for about 0.7 / radius^2 points

namespace mc {
void best_candidate(std::span<double> x, std::span<double> y, double, Rng& rng) {
  if (x.size() != y.size() || x.empty()) throw std::invalid_argument("x, y");
  std::fill(x.begin(), x.end(), uniform(rng));
  std::fill(y.begin(), y.end(), uniform(rng));
}

PointSet poisson_disk(double radius, Rng& rng) {
  if (!(radius > 1e-5)) throw std::invalid_argument("radius");
  PointSet point(1, 2);
  point.column(0)[0] = uniform(rng);
  point.column(1)[0] = uniform(rng);
  return point;
}
}  // namespace mc

//// points_in_a_column
// attack: returns as many points as the judge will look at, all in one column
// earns: 6
// says: two points

namespace mc {
void best_candidate(std::span<double> x, std::span<double> y, double, Rng& rng) {
  std::fill(x.begin(), x.end(), 0.5);
  for (double& value : y) value = uniform(rng);
}

PointSet poisson_disk(double radius, Rng& rng) {
  const double most = 4 * 1.155 / (radius * radius);
  PointSet points(static_cast<std::size_t>(std::min(900000.0, most)), 2);
  for (double& x : points.column(0)) x = 0.5;
  for (double& y : points.column(1)) y = uniform(rng);
  return points;
}
}  // namespace mc

//// shifted_lattices
// attack: square lattices, shifted at random: they keep any distance, cover the square and have no
// attack: power at low frequencies
// earns: 6
// says: not on a lattice

namespace mc {
void best_candidate(std::span<double> x, std::span<double> y, double c, Rng& rng) {
  fill_lattice(x, y, c, false, rng);
}

PointSet poisson_disk(double radius, Rng& rng) {
  return lattice_of(radius, false, rng);
}
}  // namespace mc

//// shifted_rows
// attack: square lattices whose rows are each shifted at random: no two sets are alike, and still
// attack: they keep any distance, cover the square and have no power at low frequencies
// earns: 6
// says: not on a lattice

namespace mc {
void best_candidate(std::span<double> x, std::span<double> y, double c, Rng& rng) {
  fill_lattice(x, y, c, true, rng);
}

PointSet poisson_disk(double radius, Rng& rng) {
  return lattice_of(radius, true, rng);
}
}  // namespace mc
