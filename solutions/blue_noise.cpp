// Lab 4 · blue noise: the reference solution. Each function is its definition first; where a faster
// way stands below, its reason stands with it.

#include "blue_noise.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <string>

namespace mc {
namespace {

double uniform(Rng& rng) {
  return static_cast<double>(rng() >> 11) * 0x1p-53;
}

Point2 uniform_point(Rng& rng) {
  const double x = uniform(rng);
  return {x, uniform(rng)};
}

void require_pairs(std::size_t x, std::size_t y) {
  if (x != y) throw std::invalid_argument("x and y: sizes differ");
  if (x == 0) throw std::invalid_argument("x: there are no points");
}

/// A number with two digits: 1.5e+12.
std::string in_words(double number) {
  char text[32];
  std::snprintf(text, sizeof text, "%.2g", number);
  return text;
}

std::size_t require_square(std::size_t size, int kmax) {
  if (kmax < 1) throw std::invalid_argument("kmax: below 1");
  const std::size_t side = 2 * static_cast<std::size_t>(kmax) + 1;
  if (size != side * side) throw std::invalid_argument("power: its size is not (2 kmax + 1)^2");
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
//
// The definition, for point i:
//
//   for each of ceil(c i) + 1 candidates
//     nearest = the least distance to points 0 … i-1
//     keep the candidate whose nearest is largest
//
// which looks at N points for each of N^2 / 2 candidates: N^3.
//
// 4.7  Two thoughts make it N^2:
//
// * A grid of about as many cells as points: near points lie in near cells, so a few cells answer.
// * Most candidates are bad. One that has a point nearer than the best candidate's nearest cannot
//   win, and that point usually lies in the candidate's own cell.

namespace {

/// Points of the torus, found by where they are.
class Neighbours {
 public:
  void add(Point2 point) {
    points_.push_back(point);
    if (points_.size() > side_ * side_) {
      rebuild();
    } else {
      link(points_.size() - 1);
    }
  }

  /// Squared distance to the nearest point, or to any point that is nearer than sqrt(`enough`).
  double nearest(Point2 at, double enough) const {
    const auto side = static_cast<long>(side_);
    const auto column = static_cast<long>(cell(at.x)), row = static_cast<long>(cell(at.y));
    double least = std::numeric_limits<double>::infinity();
    for (long ring = 0; 2 * (ring - 1) < side; ++ring) {
      // Rings 0 … ring-1 hold everything within ring - 1 cells.
      const double seen = static_cast<double>(ring - 1) / static_cast<double>(side);
      if (ring > 0 && least <= seen * seen) break;
      for (long j = -ring; j <= ring; ++j) {
        const long step = std::abs(j) == ring || ring == 0 ? 1 : 2 * ring;
        for (long i = -ring; i <= ring; i += step) {
          const auto where = wrapped(row + j) * side_ + wrapped(column + i);
          for (std::size_t p = first_[where]; p != none; p = next_[p]) {
            least = std::min(least, toroidal_distance_squared(at, points_[p]));
            if (least < enough) return least;
          }
        }
      }
    }
    return least;
  }

 private:
  static constexpr std::size_t none = ~std::size_t{0};

  std::size_t cell(double x) const {
    return std::min(static_cast<std::size_t>(x * static_cast<double>(side_)), side_ - 1);
  }
  std::size_t wrapped(long i) const {
    const auto side = static_cast<long>(side_);
    while (i < 0) i += side;
    while (i >= side) i -= side;
    return static_cast<std::size_t>(i);
  }
  void link(std::size_t p) {
    std::size_t& first = first_[cell(points_[p].y) * side_ + cell(points_[p].x)];
    next_.push_back(first);
    first = p;
  }
  void rebuild() {  // with four times the cells: each point moves once, on average
    side_ *= 2;
    first_.assign(side_ * side_, none);
    next_.clear();
    for (std::size_t p = 0; p < points_.size(); ++p) link(p);
  }

  std::size_t side_ = 1;  // cells along each axis
  std::vector<Point2> points_;
  std::vector<std::size_t> first_ = {none};  // of each cell: one of its points,
  std::vector<std::size_t> next_;            // and of each point: another one in its cell
};

}  // namespace

void best_candidate(std::span<double> x, std::span<double> y, double c, Rng& rng) {
  require_pairs(x.size(), y.size());
  if (!(c > 0 && std::isfinite(c))) throw std::invalid_argument("c: not positive and finite");
  Neighbours points;
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double candidates = std::ceil(c * static_cast<double>(i)) + 1;
    Point2 best;
    double farthest = -1;
    for (double k = 0; k < candidates; ++k) {
      const Point2 candidate = uniform_point(rng);
      const double nearest = points.nearest(candidate, farthest);
      if (nearest > farthest) {
        farthest = nearest;
        best = candidate;
      }
    }
    points.add(best);
    x[i] = best.x;
    y[i] = best.y;
  }
}

// 4.3 --------------------------------------------------------------------------------------------
//
// The definition is dart throwing: throw points at the square, keep those that are not too close to
// one kept before, go on until none fits. The last gaps are small, and darts hardly ever hit them:
// one can neither go on for ever nor know when to stop.
//
// 4.7  So throw only where a gap may be (Ebeida et al. 2012, "A simple algorithm for maximal
// Poisson-disk sampling in high dimensions"):
//
// * The square is cut into cells so small that a cell holds one point at most. All are active.
// * Darts fall on active cells, which cover every gap: the next point that is kept is uniform in
//   the gaps, as with darts thrown at the whole square. The pattern is a dart thrower's, exactly.
// * After one dart a cell, every active cell is quartered. A quarter that lies within one disc has
//   no gap in it and is dropped. What is left shrinks towards the gaps.
//
// Each step looks at the few cells around. The number of active cells stays in proportion to that
// of the points, and after ten quarterings they cover less than 1e-4 of the square.

namespace {

constexpr int quarterings = 10;

class DiskPattern {
 public:
  explicit DiskPattern(double radius)
      : radius_squared_(radius * radius),
        side_(static_cast<std::uint32_t>(std::ceil(std::numbers::sqrt2 / radius))),
        point_in_(std::size_t{side_} * side_, none) {
    const int reach = static_cast<int>(std::ceil(radius * side_));
    for (int j = -reach; j <= reach; ++j) {
      for (int i = -reach; i <= reach; ++i) around_.push_back({i, j});
    }
    std::sort(around_.begin(), around_.end(),
              [](Step a, Step b) { return a.i * a.i + a.j * a.j < b.i * b.i + b.j * b.j; });
  }

  void fill(Rng& rng) {
    for (std::uint32_t j = 0; j < side_; ++j) {
      for (std::uint32_t i = 0; i < side_; ++i) active_.push_back({i, j});
    }
    for (level_ = 0; level_ <= quarterings && !active_.empty(); ++level_) {
      throw_darts(rng);
      quarter();
    }
  }

  const std::vector<Point2>& points() const { return points_; }

 private:
  static constexpr std::uint32_t none = ~std::uint32_t{0};

  struct Cell {  // of a grid of side_ 2^level_ cells along each axis
    std::uint32_t i, j;
  };
  struct Step {
    int i, j;
  };

  double width() const { return std::ldexp(1.0 / side_, -level_); }

  void throw_darts(Rng& rng) {
    const double cell_width = width();
    for (std::size_t darts = active_.size(); darts > 0 && !active_.empty(); --darts) {
      Cell& cell = active_[static_cast<std::size_t>(uniform(rng) * double(active_.size()))];
      const Point2 u = uniform_point(rng);
      const Point2 dart{std::min((double(cell.i) + u.x) * cell_width, below_one),
                        std::min((double(cell.j) + u.y) * cell_width, below_one)};
      if (covered(dart, 0)) continue;
      point_in_[grid_index(dart)] = static_cast<std::uint32_t>(points_.size());
      points_.push_back(dart);
      cell = active_.back();
      active_.pop_back();
    }
  }

  void quarter() {
    std::vector<Cell> quarters;
    const double half = width() / 4;
    for (const Cell& cell : active_) {
      for (unsigned q = 0; q < 4; ++q) {
        const Cell child{2 * cell.i + q % 2, 2 * cell.j + q / 2};
        const Point2 centre{(2 * double(child.i) + 1) * half, (2 * double(child.j) + 1) * half};
        if (!covered(centre, half)) quarters.push_back(child);
      }
    }
    active_ = std::move(quarters);
  }

  /// Does the disc of some point hold the whole square of half-width `half` around `centre`?
  bool covered(Point2 centre, double half) const {
    const auto i = static_cast<int>(centre.x * side_), j = static_cast<int>(centre.y * side_);
    for (const auto& [di, dj] : around_) {
      const std::uint32_t p = point_in_[std::size_t{wrapped(j + dj)} * side_ + wrapped(i + di)];
      if (p == none) continue;
      double dx = std::abs(centre.x - points_[p].x), dy = std::abs(centre.y - points_[p].y);
      dx = std::min(dx, 1 - dx) + half;  // to the farthest corner
      dy = std::min(dy, 1 - dy) + half;
      if (dx * dx + dy * dy < radius_squared_) return true;
    }
    return false;
  }

  std::size_t grid_index(Point2 p) const {
    return static_cast<std::size_t>(p.y * side_) * side_ + static_cast<std::size_t>(p.x * side_);
  }
  std::uint32_t wrapped(int i) const {
    const int side = static_cast<int>(side_);
    while (i < 0) i += side;
    while (i >= side) i -= side;
    return static_cast<std::uint32_t>(i);
  }

  static constexpr double below_one = 1 - 0x1p-53;

  double radius_squared_;
  std::uint32_t side_;        // cells along each axis: a cell's diagonal is the radius at most
  std::vector<Step> around_;  // to the cells that a radius spans, near ones first: they cover most
  int level_ = 0;
  std::vector<Point2> points_;
  std::vector<std::uint32_t> point_in_;  // of each cell of level 0
  std::vector<Cell> active_;
};

}  // namespace

PointSet poisson_disk(double radius, Rng& rng) {
  if (!(radius > 0)) throw std::invalid_argument("radius: not positive");
  if (radius < 1e-5) {
    throw std::invalid_argument("radius: too small for memory, about " +
                                in_words(0.7 / radius / radius) + " points");
  }
  DiskPattern pattern(std::min(radius, 1.0));  // from sqrt(1/2) on, one disc covers everything
  pattern.fill(rng);
  PointSet points(pattern.points().size(), 2);
  for (std::size_t i = 0; i < points.size(); ++i) {
    points.column(0)[i] = pattern.points()[i].x;
    points.column(1)[i] = pattern.points()[i].y;
  }
  return points;
}

// 4.4 --------------------------------------------------------------------------------------------
//
// The definition would be, for each k:
//
//   sum = 0
//   for each point: sum += exp(-2 pi i (kx x + ky y))
//   power = |sum|^2 / N
//
// with a sine and a cosine for each of N (2 kmax + 1)^2 terms. But exp(a + b) = exp(a) exp(b): the
// waves along x and along y are enough, N (2 kmax + 1) of each, and a term is a product. And
// the power at -k is that at k, since the points are real: half of it is never computed.

void periodogram(std::span<const double> x, std::span<const double> y, int kmax,
                 std::span<double> power) {
  require_pairs(x.size(), y.size());
  const std::size_t side = require_square(power.size(), kmax);
  const auto n = static_cast<double>(x.size());
  const auto centre = static_cast<std::size_t>(kmax);
  std::vector<double> cosine(side), sine(side);                   // of kx x
  std::vector<double> real(side * side), imaginary(side * side);  // sums, for ky >= 0
  for (std::size_t p = 0; p < x.size(); ++p) {
    for (std::size_t i = 0; i < side; ++i) {
      const double angle = 2 * std::numbers::pi * (static_cast<double>(i) - kmax) * x[p];
      cosine[i] = std::cos(angle);
      sine[i] = std::sin(angle);
    }
    for (std::size_t j = centre; j < side; ++j) {
      const double angle = 2 * std::numbers::pi * static_cast<double>(j - centre) * y[p];
      const double c = std::cos(angle), s = std::sin(angle);
      for (std::size_t i = 0; i < side; ++i) {
        real[j * side + i] += c * cosine[i] - s * sine[i];
        imaginary[j * side + i] += s * cosine[i] + c * sine[i];
      }
    }
  }
  for (std::size_t k = centre * side; k < side * side; ++k) {
    const double value = (real[k] * real[k] + imaginary[k] * imaginary[k]) / n;
    power[k] = power[side * side - 1 - k] = value;  // k, and -k on the other side of the centre
  }
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
  if (copies < 1) throw std::invalid_argument("copies: below 1");
  if (pattern.dims() != 2) throw std::invalid_argument("pattern: not in two dimensions");
  if (pattern.size() == 0) throw std::invalid_argument("pattern: there are no points");
  const auto place = [&](int cell, double x) {  // the sum may be rounded up to the next cell
    return std::min((cell + x) / copies, 1 - 0x1p-53);
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
