// Lab 4 · blue noise: the reference solution. A speed task has its definition first, then a faster
// version with the reason why it is faster.

#include "blue_noise.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstdint>
#include <cstdio>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <string>

namespace mc {
namespace {

constexpr double below_one = 1 - 0x1p-53;  // the largest double below 1

double uniform(Rng& rng) {
  return static_cast<double>(rng() >> 11) * 0x1p-53;
}

Point2 uniform_point(Rng& rng) {
  const double x = uniform(rng);
  return {x, uniform(rng)};
}

void require_pairs(std::size_t x, std::size_t y) {
  if (x != y) throw std::invalid_argument("x and y: sizes differ");
  if (x == 0) throw std::invalid_argument("x: no points");
}

/// A number printed with two digits: 1.5e+12.
std::string two_digits(double number) {
  char text[32];
  return {text, text + std::snprintf(text, sizeof text, "%.2g", number)};
}

std::size_t require_square(std::size_t size, int kmax) {
  if (kmax < 1) throw std::invalid_argument("kmax: must be at least 1");
  const std::size_t side = 2 * static_cast<std::size_t>(kmax) + 1;
  if (size != side * side) throw std::invalid_argument("power: the size must be (2 kmax + 1)^2");
  return side;
}

}  // namespace

// 4.1 --------------------------------------------------------------------------------------------

double toroidal_distance_squared(Point2 a, Point2 b) {
  double dx = std::abs(a.x - b.x);
  double dy = std::abs(a.y - b.y);
  dx = std::min(dx, 1 - dx);
  dy = std::min(dy, 1 - dy);
  return dx * dx + dy * dy;
}

// 4.2 --------------------------------------------------------------------------------------------

namespace definition {
void best_candidate(std::span<double> x, std::span<double> y, double c, Rng& rng) {
  for (std::size_t i = 0; i < x.size(); ++i) {
    double farthest = -1;
    for (double left = std::ceil(c * static_cast<double>(i)) + 1; left > 0; --left) {
      const Point2 candidate = uniform_point(rng);
      double nearest = 1;
      for (std::size_t j = 0; j < i; ++j) {
        nearest = std::min(nearest, toroidal_distance_squared(candidate, {x[j], y[j]}));
      }
      if (nearest > farthest) farthest = nearest, x[i] = candidate.x, y[i] = candidate.y;
    }
  }
}
}  // namespace definition

// 4.7  The definition looks at up to N points for each of c N^2 / 2 candidates: O(c N^3). Two ideas
// reduce it to O(c N^2):
//
// * A grid with about as many cells as points: nearby points lie in nearby cells, so a search
//   visits only a few cells.
// * Most candidates are bad. A candidate cannot win if it has a point that is nearer than the
//   nearest point of the best candidate so far, and such a point usually lies in the candidate's
//   own cell.

namespace {

/// Points of the torus in a grid of side x side cells, for searches by position. The number of
/// cells is between once and four times the number of points.
class Neighbors {
 public:
  void add(Point2 point) {
    points_.push_back(point);
    if (points_.size() <= first_.size()) return link(points_.size() - 1);
    side_ *= 2;  // amortized, each point moves about once
    first_.assign(4 * first_.size(), none);
    next_.clear();
    for (std::size_t p = 0; p < points_.size(); ++p) link(p);
  }

  /// The squared distance from `to` to the nearest point; or, if there are points whose squared
  /// distance is below `enough`, that of any one of them. Infinite if there are no points.
  double nearest(Point2 to, double enough) const {
    const long column = cell_of(to.x), row = cell_of(to.y);
    double least = std::numeric_limits<double>::infinity();
    for (long ring = 0; 2 * (ring - 1) < side_; ++ring) {
      // Rings 0 … ring-1 contain all points within a distance of ring - 1 cells.
      const double searched = static_cast<double>(ring - 1) / static_cast<double>(side_);
      if (ring > 0 && least <= searched * searched) break;
      for (long j = -ring; j <= ring; ++j) {
        const long step = std::abs(j) == ring || ring == 0 ? 1 : 2 * ring;
        for (long i = -ring; i <= ring; i += step) {
          for (auto p = first_[at(column + i, row + j)]; p != none; p = next_[p]) {
            least = std::min(least, toroidal_distance_squared(to, points_[p]));
            if (least < enough) return least;
          }
        }
      }
    }
    return least;
  }

  const std::vector<Point2>& all() const { return points_; }

 private:
  static constexpr std::uint32_t none = ~std::uint32_t{0};

  long cell_of(double x) const { return static_cast<long>(x * static_cast<double>(side_)); }
  std::size_t at(long i, long j) const {  // left meets right, and top meets bottom
    return static_cast<std::size_t>((j & (side_ - 1)) * side_ + (i & (side_ - 1)));
  }
  void link(std::size_t p) {
    std::uint32_t& first = first_[at(cell_of(points_[p].x), cell_of(points_[p].y))];
    next_.push_back(first);
    first = static_cast<std::uint32_t>(p);
  }

  long side_ = 1;  // a power of 2
  std::vector<Point2> points_;
  std::vector<std::uint32_t> first_ = {none};  // for each cell, its first point
  std::vector<std::uint32_t> next_;            // for each point, the next point in its cell
};

}  // namespace

void best_candidate(std::span<double> x, std::span<double> y, double c, Rng& rng) {
  require_pairs(x.size(), y.size());
  if (!(c > 0 && std::isfinite(c))) throw std::invalid_argument("c: must be positive and finite");
  Neighbors points;
  for (std::size_t i = 0; i < x.size(); ++i) {
    double farthest = -1;
    for (double left = std::ceil(c * static_cast<double>(i)) + 1; left > 0; --left) {
      const Point2 candidate = uniform_point(rng);
      const double nearest = points.nearest(candidate, farthest);
      if (nearest > farthest) farthest = nearest, x[i] = candidate.x, y[i] = candidate.y;
    }
    points.add({x[i], y[i]});
  }
}

// 4.3 --------------------------------------------------------------------------------------------

namespace {

PointSet columns_of(const std::vector<Point2>& from) {
  PointSet points(from.size(), 2);
  for (std::size_t i = 0; i < from.size(); ++i) {
    points.column(0)[i] = from[i].x;
    points.column(1)[i] = from[i].y;
  }
  return points;
}

}  // namespace

namespace definition {
PointSet poisson_disk(double radius, Rng& rng) {
  std::vector<Point2> points;
  for (int misses = 0; misses < 10000; ++misses) {  // by then, at most 0.1 % is uncovered
    const Point2 dart = uniform_point(rng);
    const auto covers = [&](Point2 p) {
      return toroidal_distance_squared(p, dart) < radius * radius;
    };
    if (std::any_of(points.begin(), points.end(), covers)) continue;
    points.push_back(dart);
    misses = -1;
  }
  return columns_of(points);
}
}  // namespace definition

// 4.7  Darts rarely hit the last, small gaps. So throw them only where a gap may be (Ebeida et al.
// 2012, "A simple algorithm for maximal Poisson-disk sampling in high dimensions"):
//
// * Divide the square into cells so small that no cell can contain two points. At first all cells
//   are active.
// * Throw darts at active cells only. These cover all gaps, so the next accepted point is uniform
//   in the gaps, as it is with darts thrown at the whole square: the pattern has exactly the
//   distribution of dart throwing.
// * After as many darts as there were active cells, split each active cell into quarters. Drop a
//   quarter if it lies within one disk, since it has no gap. After ten splits, less than 1e-4 of
//   the square is active.

PointSet poisson_disk(double radius, Rng& rng) {
  if (!(radius > 0)) throw std::invalid_argument("radius: must be positive");
  if (radius < 1e-5) {
    throw std::invalid_argument("radius: too small, would give about " +
                                two_digits(0.7 / radius / radius) + " points");
  }
  radius = std::min(radius, 1.0);  // above sqrt(1/2), one disk covers everything
  Neighbors points;
  const auto has_point_within = [&](double distance, Point2 place) {
    return points.nearest(place, distance * distance) < distance * distance;
  };
  const double side = std::ceil(std::numbers::sqrt2 / radius);
  double width = 1 / side;
  std::vector<Point2> active, quarters;  // cells, by their lower left corners
  for (double j = 0; j < side; ++j) {
    for (double i = 0; i < side; ++i) active.push_back({i * width, j * width});
  }
  for (int level = 0; level <= 10 && !active.empty(); ++level) {
    for (std::size_t darts = active.size(); darts > 0 && !active.empty(); --darts) {
      Point2& cell =
          active[static_cast<std::size_t>(uniform(rng) * static_cast<double>(active.size()))];
      const Point2 u = uniform_point(rng);
      const Point2 dart{std::min(cell.x + u.x * width, below_one),
                        std::min(cell.y + u.y * width, below_one)};
      if (has_point_within(radius, dart)) continue;
      points.add(dart);
      cell = active.back();
      active.pop_back();
    }
    width /= 2;
    const double half_diagonal = width / std::numbers::sqrt2;
    quarters.clear();
    for (const Point2 cell : active) {
      for (const Point2 step : {Point2{0, 0}, {width, 0}, {0, width}, {width, width}}) {
        const Point2 quarter{cell.x + step.x, cell.y + step.y};
        const Point2 center{quarter.x + width / 2, quarter.y + width / 2};
        if (!has_point_within(radius - half_diagonal, center)) quarters.push_back(quarter);
      }
    }
    active.swap(quarters);
  }
  return columns_of(points.all());
}

// 4.4 --------------------------------------------------------------------------------------------

namespace definition {
void periodogram(std::span<const double> x, std::span<const double> y, int kmax,
                 std::span<double> power) {
  std::size_t i = 0;
  for (int ky = -kmax; ky <= kmax; ++ky) {
    for (int kx = -kmax; kx <= kmax; ++kx) {
      std::complex<double> sum = 0;
      for (std::size_t p = 0; p < x.size(); ++p) {
        sum += std::polar(1.0, -2 * std::numbers::pi * (kx * x[p] + ky * y[p]));
      }
      power[i++] = std::norm(sum) / static_cast<double>(x.size());
    }
  }
}
}  // namespace definition

// The definition computes a sine and a cosine for each of N (2 kmax + 1)^2 terms. But exp(a + b) =
// exp(a) exp(b): a term is the product of a wave along x and a wave along y, and there are only
// N (2 kmax + 1) of each.

void periodogram(std::span<const double> x, std::span<const double> y, int kmax,
                 std::span<double> power) {
  require_pairs(x.size(), y.size());
  const std::size_t side = require_square(power.size(), kmax);
  const auto wave = [](double k, double at) {
    return std::polar(1.0, -2 * std::numbers::pi * k * at);
  };
  std::vector<std::complex<double>> along_x(side), sum(side * side);
  for (std::size_t p = 0; p < x.size(); ++p) {
    for (std::size_t i = 0; i < side; ++i) along_x[i] = wave(static_cast<double>(i) - kmax, x[p]);
    for (std::size_t j = 0; j < side; ++j) {
      const auto along_y = wave(static_cast<double>(j) - kmax, y[p]);
      for (std::size_t i = 0; i < side; ++i) sum[j * side + i] += along_x[i] * along_y;
    }
  }
  for (std::size_t k = 0; k < power.size(); ++k)
    power[k] = std::norm(sum[k]) / static_cast<double>(x.size());
}

// 4.5 --------------------------------------------------------------------------------------------

std::vector<double> radial_power(std::span<const double> power, int kmax) {
  require_square(power.size(), kmax);
  std::vector<double> sum(static_cast<std::size_t>(kmax) + 1), count(sum.size());
  std::size_t i = 0;
  for (int ky = -kmax; ky <= kmax; ++ky) {
    for (int kx = -kmax; kx <= kmax; ++kx, ++i) {
      const auto ring = static_cast<std::size_t>(std::lround(std::hypot(kx, ky)));
      if (ring >= sum.size()) continue;  // a corner
      sum[ring] += power[i];
      ++count[ring];
    }
  }
  for (std::size_t ring = 0; ring < sum.size(); ++ring) sum[ring] /= count[ring];
  sum[0] = std::numeric_limits<double>::quiet_NaN();
  return sum;
}

// 4.6 --------------------------------------------------------------------------------------------

PointSet tile(const PointSet& pattern, int copies) {
  if (copies < 1) throw std::invalid_argument("copies: must be at least 1");
  if (pattern.dims() != 2) throw std::invalid_argument("pattern: must have two dimensions");
  if (pattern.size() == 0) throw std::invalid_argument("pattern: no points");
  const auto place = [&](int cell, double x) {  // cell + x may be rounded up to `copies`
    return std::min((cell + x) / copies, below_one);
  };
  const auto repeats = static_cast<std::size_t>(copies);
  PointSet tiled(repeats * repeats * pattern.size(), 2);
  std::size_t i = 0;
  for (int row = 0; row < copies; ++row) {
    for (int column = 0; column < copies; ++column) {
      for (std::size_t p = 0; p < pattern.size(); ++p, ++i) {
        tiled.column(0)[i] = place(column, pattern.column(0)[p]);
        tiled.column(1)[i] = place(row, pattern.column(1)[p]);
      }
    }
  }
  return tiled;
}

}  // namespace mc
