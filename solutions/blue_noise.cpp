// Lab 4 · blue noise: the reference solution. Speed tasks show a definition, then the faster way.

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

constexpr double below_one = 1 - 0x1p-53;  // the largest double that is

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
  return {text, text + std::snprintf(text, sizeof text, "%.2g", number)};
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

namespace definition {
void best_candidate(std::span<double> x, std::span<double> y, double c, Rng& rng) {
  for (std::size_t i = 0; i < x.size(); ++i) {
    double farthest = -1;
    for (double left = std::ceil(c * double(i)) + 1; left > 0; --left) {
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

// That looks at N points for each of N^2 / 2 candidates: N^3.
// 4.7  Two thoughts make it N^2:
//
// * A grid of about as many cells as points: near points lie in near cells, so a few cells answer.
// * Most candidates are bad. One that has a point nearer than the best candidate's nearest cannot
//   win, and that point usually lies in the candidate's own cell.

namespace {

constexpr std::uint32_t none = ~std::uint32_t{0};

/// side x side cells of the torus: left meets right, and top meets bottom.
struct Cells {
  long side;

  long of(double x) const { return std::min(static_cast<long>(x * double(side)), side - 1); }
  std::size_t at(long i, long j) const {
    return static_cast<std::size_t>(wrapped(j) * side + wrapped(i));
  }
  std::size_t count() const { return static_cast<std::size_t>(side * side); }

 private:
  long wrapped(long i) const {
    while (i < 0) i += side;
    while (i >= side) i -= side;
    return i;
  }
};

/// Points of the torus, found by where they are.
class Neighbours {
 public:
  void add(Point2 point) {
    points_.push_back(point);
    const auto number = static_cast<std::uint32_t>(points_.size() - 1);
    if (points_.size() <= cells_.count()) return link(number);
    cells_.side *= 2;  // four times the cells: each point moves once, on average
    first_.assign(cells_.count(), none);
    next_.clear();
    for (std::uint32_t p = 0; p <= number; ++p) link(p);
  }

  /// Squared distance to the nearest point, or to any point that is nearer than sqrt(`enough`).
  double nearest(Point2 to, double enough) const {
    const long column = cells_.of(to.x), row = cells_.of(to.y);
    double least = std::numeric_limits<double>::infinity();
    for (long ring = 0; 2 * (ring - 1) < cells_.side; ++ring) {
      // Rings 0 … ring-1 hold everything within ring - 1 cells.
      const double seen = double(ring - 1) / double(cells_.side);
      if (ring > 0 && least <= seen * seen) break;
      for (long j = -ring; j <= ring; ++j) {
        const long step = std::abs(j) == ring || ring == 0 ? 1 : 2 * ring;
        for (long i = -ring; i <= ring; i += step) {
          for (auto p = first_[cells_.at(column + i, row + j)]; p != none; p = next_[p]) {
            least = std::min(least, toroidal_distance_squared(to, points_[p]));
            if (least < enough) return least;
          }
        }
      }
    }
    return least;
  }

 private:
  void link(std::uint32_t p) {
    std::uint32_t& first = first_[cells_.at(cells_.of(points_[p].x), cells_.of(points_[p].y))];
    next_.push_back(first);
    first = p;
  }

  Cells cells_{1};
  std::vector<Point2> points_;
  std::vector<std::uint32_t> first_ = {none};  // of each cell: one of its points,
  std::vector<std::uint32_t> next_;            // and of each point: another one in its cell
};

}  // namespace

void best_candidate(std::span<double> x, std::span<double> y, double c, Rng& rng) {
  require_pairs(x.size(), y.size());
  if (!(c > 0 && std::isfinite(c))) throw std::invalid_argument("c: not positive and finite");
  Neighbours points;
  for (std::size_t i = 0; i < x.size(); ++i) {
    double farthest = -1;
    for (double left = std::ceil(c * double(i)) + 1; left > 0; --left) {
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
  for (int misses = 0; misses < 10000; ++misses) {  // then 0.1 % is left, or less
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

// Darts hardly ever hit the last gaps, the small ones. 4.7: throw only where a gap may be (Ebeida
// et al. 2012, "A simple algorithm for maximal Poisson-disk sampling in high dimensions"):
//
// * The square is cut into cells so small that a cell holds one point at most. All are active.
// * Darts fall on active cells, which cover every gap: the next point that is kept is uniform in
//   the gaps, as with darts thrown at the whole square. The pattern is a dart thrower's, exactly.
// * After one dart a cell, every active cell is quartered. A quarter that lies within one disc has
//   no gap in it and is dropped. After ten quarterings, less than 1e-4 of the square is active.

namespace {

class DiskPattern {
 public:
  explicit DiskPattern(double radius)
      : radius_squared_(radius * radius),
        cells_{static_cast<long>(std::ceil(std::numbers::sqrt2 / radius))},
        point_in_(cells_.count(), none) {
    const int reach = static_cast<int>(std::ceil(radius * double(cells_.side)));
    for (int j = -reach; j <= reach; ++j) {
      for (int i = -reach; i <= reach; ++i) around_.push_back({i, j});
    }
    const auto nearer = [](Cell a, Cell b) {
      return a.i * a.i + a.j * a.j < b.i * b.i + b.j * b.j;
    };
    std::sort(around_.begin(), around_.end(), nearer);
  }

  std::vector<Point2> fill(Rng& rng) {
    for (int j = 0; j < cells_.side; ++j) {
      for (int i = 0; i < cells_.side; ++i) active_.push_back({i, j});
    }
    double width = 1 / double(cells_.side);
    for (int level = 0; level <= 10 && !active_.empty(); ++level, width /= 2) {
      throw_darts(width, rng);
      quarter(width / 4);
    }
    return points_;
  }

 private:
  struct Cell {
    int i, j;
  };

  void throw_darts(double width, Rng& rng) {
    for (std::size_t darts = active_.size(); darts > 0 && !active_.empty(); --darts) {
      Cell& cell = active_[static_cast<std::size_t>(uniform(rng) * double(active_.size()))];
      const Point2 u = uniform_point(rng);
      const Point2 dart{std::min((double(cell.i) + u.x) * width, below_one),
                        std::min((double(cell.j) + u.y) * width, below_one)};
      if (covered(dart, 0)) continue;
      point_in_[cells_.at(cells_.of(dart.x), cells_.of(dart.y))] =
          static_cast<std::uint32_t>(points_.size());
      points_.push_back(dart);
      cell = active_.back();
      active_.pop_back();
    }
  }

  /// Cuts the active cells into quarters of half-width `half`.
  void quarter(double half) {
    std::vector<Cell> quarters;
    for (const Cell& cell : active_) {
      for (int q = 0; q < 4; ++q) {
        const Cell child{2 * cell.i + q % 2, 2 * cell.j + q / 2};
        const Point2 centre{double(2 * child.i + 1) * half, double(2 * child.j + 1) * half};
        if (!covered(centre, half)) quarters.push_back(child);
      }
    }
    active_ = std::move(quarters);
  }

  /// Does the disc of some point hold the whole square of half-width `half` around `centre`?
  bool covered(Point2 centre, double half) const {
    const long i = cells_.of(centre.x), j = cells_.of(centre.y);
    for (const Cell& step : around_) {
      const std::uint32_t p = point_in_[cells_.at(i + step.i, j + step.j)];
      if (p == none) continue;
      double dx = std::abs(centre.x - points_[p].x), dy = std::abs(centre.y - points_[p].y);
      dx = std::min(dx, 1 - dx) + half;  // to the farthest corner
      dy = std::min(dy, 1 - dy) + half;
      if (dx * dx + dy * dy < radius_squared_) return true;
    }
    return false;
  }

  double radius_squared_;
  Cells cells_;               // a cell's diagonal is the radius at most
  std::vector<Cell> around_;  // steps to what a radius spans, near ones first: they cover most
  std::vector<Point2> points_;
  std::vector<std::uint32_t> point_in_;  // of each cell
  std::vector<Cell> active_;             // cells or parts of them: of a grid 2^level times as fine
};

}  // namespace

PointSet poisson_disk(double radius, Rng& rng) {
  if (!(radius > 0)) throw std::invalid_argument("radius: not positive");
  if (radius < 1e-5) {
    throw std::invalid_argument("radius: too small for memory, about " +
                                in_words(0.7 / radius / radius) + " points");
  }
  // From sqrt(1/2) on, one disc covers everything.
  return columns_of(DiskPattern(std::min(radius, 1.0)).fill(rng));
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
      power[i++] = std::norm(sum) / double(x.size());
    }
  }
}
}  // namespace definition

// That is a sine and a cosine for each of N (2 kmax + 1)^2 terms. But exp(a + b) = exp(a) exp(b):
// the waves along x and along y are enough, N (2 kmax + 1) of each, and a term is a product. And
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
