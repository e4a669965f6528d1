// Lab 3 · stratification: the reference solution. A speed task has its definition first, then a
// faster version with the reason why it is faster.

#include "stratification.hpp"
#include "common/choices.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <vector>

namespace mc {

// 3.10 --------------------------------------------------------------------------------------------

namespace definition {
/// Maps u in [0, 1) to stratum i of n. The sum or the quotient may be rounded up to the upper edge
/// of the stratum; the result is then the double just below the edge.
double in_stratum(std::size_t i, std::size_t n, double u) {
  const auto stratum = static_cast<double>(i), strata = static_cast<double>(n);
  return std::min((stratum + u) / strata, std::nextafter((stratum + 1) / strata, 0.0));
}
}  // namespace definition

// The definition needs two divisions per number and, in 3.1 and 3.3, one call of the generator, one
// after another. The faster version neither divides nor clamps, and no number waits for another:
//
// * The jitter keeps a margin from both edges of its stratum, 2^-50 of the whole axis, which is
//   more than the sum of all rounding errors. So no value reaches an edge, and multiplying by the
//   rounded 1/n is accurate enough.
// * Random numbers are generated in blocks (2.8), which stay in the first-level cache until they
//   have been moved into their strata.
// * Within a block, the number of a stratum is an int, which vector units can convert to double.

namespace {

constexpr std::size_t block_size = 1024;  // 8 KB

/// The n strata of [0,1).
class Strata {
 public:
  explicit Strata(std::size_t n)
      : margin_(static_cast<double>(n) * 0x1p-50),
        scale_(1 - 2 * margin_),
        width_(1 / static_cast<double>(n)) {}

  /// Maps u in [0,1) to stratum i. Five quantities are rounded, each by at most 2^-53 of the axis:
  /// the jitter, the sum, the width, the product, and the edge that must not be reached. The margin
  /// is 8 * 2^-53.
  double place(double i, double u) const { return (i + (margin_ + scale_ * u)) * width_; }

 private:
  double margin_, scale_, width_;  // in units of a stratum, a factor, in units of the axis
};

/// Moves the values of `u`, each in [0,1), into the strata first, first + 1, …
void move_into(const Strata& strata, std::size_t first, std::span<double> u) {
  const auto start = static_cast<double>(first);
  double* const x = u.data();
  for (int i = 0; i < static_cast<int>(u.size()); ++i) x[i] = strata.place(start + i, x[i]);
}

}  // namespace

// 3.1 ---------------------------------------------------------------------------------------------

namespace definition {
void stratified_1d(std::span<double> x, Rng& rng) {
  for (std::size_t i = 0; i < x.size(); ++i) x[i] = in_stratum(i, x.size(), to_unit(rng()));
}
}  // namespace definition

void stratified_1d(std::span<double> x, Rng& rng) {
  const Strata strata(x.size());
  for (std::size_t first = 0; first < x.size(); first += block_size) {
    const auto block = x.subspan(first, std::min(block_size, x.size() - first));
    uniforms(rng, block);
    move_into(strata, first, block);
  }
}

// 3.2 ---------------------------------------------------------------------------------------------

Grid strata(std::size_t n) {
  if (n == 0) throw std::invalid_argument("n: must be positive");
  auto ny = static_cast<std::size_t>(std::sqrt(static_cast<double>(n)));
  while (n % ny != 0) --ny;  // 1 divides everything
  return {n / ny, ny};
}

// 3.3 ---------------------------------------------------------------------------------------------

namespace {

void require_grid(std::span<const double> x, std::span<const double> y, Grid grid) {
  if (x.size() != y.size()) throw std::invalid_argument("x and y: sizes differ");
  if (grid.nx == 0 || grid.ny == 0) throw std::invalid_argument("grid: nx and ny must be positive");
  // Do not compare with the product nx * ny: it may overflow and be equal by chance.
  if (x.size() % grid.nx != 0 || x.size() / grid.nx != grid.ny) {
    throw std::invalid_argument("grid: nx * ny is not the number of points");
  }
}

}  // namespace

namespace definition {
void stratified_2d(std::span<double> x, std::span<double> y, Grid grid, Rng& rng) {
  const std::size_t n = x.size();
  for (std::size_t k = 0; k < n; ++k) x[k] = in_stratum(k % grid.nx, grid.nx, to_unit(rng()));
  for (std::size_t k = 0; k < n; ++k) y[k] = in_stratum(k / grid.nx, grid.ny, to_unit(rng()));
}
}  // namespace definition

void stratified_2d(std::span<double> x, std::span<double> y, Grid grid, Rng& rng) {
  require_grid(x, y, grid);
  const Strata columns(grid.nx), rows(grid.ny);
  std::size_t column = 0, row = 0;  // of the next cell, row by row
  for (std::size_t first = 0; first < x.size(); first += block_size) {
    const std::size_t end = std::min(first + block_size, x.size());
    uniforms(rng, x.subspan(first, end - first));
    uniforms(rng, y.subspan(first, end - first));
    for (std::size_t k = first; k < end;) {
      const std::size_t size = std::min(grid.nx - column, end - k);
      move_into(columns, column, x.subspan(k, size));
      for (double& value : y.subspan(k, size)) {
        value = rows.place(static_cast<double>(row), value);
      }
      k += size;
      column += size;
      if (column == grid.nx) column = 0, ++row;
    }
  }
}

// 3.4 ---------------------------------------------------------------------------------------------

namespace {

/// Fisher-Yates: puts n items into random order. `swap(i, j)` exchanges two items. First a random
/// one of all n items becomes the last one, then a random one of the other n - 1 becomes the one
/// before it, and so on. Random numbers are drawn ahead of the swaps, so that a processor can fetch
/// many items at once when they do not fit into the cache.
void shuffle_by(auto swap, std::size_t n, Rng& rng) {
  std::array<std::size_t, 64> ahead;
  for (Choices any(rng); n > 1;) {
    const auto block = std::span(ahead).first(std::min(ahead.size(), n - 1));
    for (std::size_t k = 0; k < block.size(); ++k) block[k] = any.below(n - k);
    for (const std::size_t last : block) swap(--n, last);
  }
}

}  // namespace

void shuffle(std::span<double> values, Rng& rng) {
  double* const x = values.data();  // a span may check every index
  shuffle_by([x](std::size_t i, std::size_t j) { std::swap(x[i], x[j]); }, values.size(), rng);
}

void stratified(PointSet& points, Rng& rng) {
  const std::size_t n = points.size(), odd = points.dims() % 2;
  for (std::size_t d = 0; d + odd < points.dims(); d += 2) {
    const auto x = points.column(d), y = points.column(d + 1);
    stratified_2d(x, y, strata(n), rng);
    const auto swap = [&](std::size_t i, std::size_t j) {  // x and y of a point stay together
      std::swap(x[i], x[j]);
      std::swap(y[i], y[j]);
    };
    shuffle_by(swap, n, rng);
  }
  if (odd == 1) {
    const auto last = points.column(points.dims() - 1);
    stratified_1d(last, rng);
    shuffle(last, rng);
  }
}

// 3.5 ---------------------------------------------------------------------------------------------

void stratified_nd(PointSet& points, std::size_t per_axis, Rng& rng) {
  if (per_axis == 0) throw std::invalid_argument("per_axis: must be positive");
  std::size_t rest = points.size();  // divide, since the power may overflow
  bool divides = true;
  for (std::size_t d = 0; d < points.dims(); ++d) {
    divides = divides && rest % per_axis == 0;
    rest /= per_axis;
  }
  if (!divides || rest != 1) {
    throw std::invalid_argument("per_axis: per_axis^dims is not the number of points");
  }

  // Point k lies in cell k. Its stratum along axis d is digit d of k in base per_axis, which is the
  // same for per_axis^d consecutive points.
  const Strata strata(per_axis);
  std::size_t stride = 1;
  for (std::size_t d = 0; d < points.dims(); ++d, stride *= per_axis) {
    const auto column = points.column(d);
    uniforms(rng, column);
    std::size_t digit = 0;
    for (std::size_t first = 0; first < column.size(); first += stride) {
      for (double& value : column.subspan(first, stride)) {
        value = strata.place(static_cast<double>(digit), value);
      }
      if (++digit == per_axis) digit = 0;
    }
  }
}

// 3.6 ---------------------------------------------------------------------------------------------

void latin_hypercube(PointSet& points, Rng& rng) {
  for (std::size_t d = 0; d < points.dims(); ++d) {
    stratified_1d(points.column(d), rng);
    shuffle(points.column(d), rng);
  }
}

// 3.7 ---------------------------------------------------------------------------------------------

// A column of cells contains ny of the N strata of x; a random permutation assigns one of them to
// each cell. In the same way, a row of cells contains nx strata of y.
//
// An independent permutation for each column takes N random numbers per axis. If all columns share
// one permutation (Kensler 2013), the points of a row lie at the same place in their cells: their
// errors add up, and the RMSE falls as N^-3/4 instead of N^-1. So each column uses the shared
// permutation from a random start. Then any two points have the same joint distribution as with
// independent permutations (in one column: two entries of a random permutation; in different
// columns: independent). The variance of an estimate depends on pairs only, so it is the same for
// every integrand, and it costs one random number per column. docs/multi-jittered.md has the proof.

namespace {

/// Writes a random permutation of 0 … n-1 twice in a row, n = order.size() / 2, so that n entries
/// can be read from any start below n. (Fisher-Yates, inside out: it also writes the numbers.)
void permute_twice(std::span<double> order, Choices& any) {
  const std::size_t n = order.size() / 2;
  double *const once = order.data(), *const again = once + n;
  for (std::size_t k = 0; k < n; ++k) {
    const std::size_t other = any.below(k + 1);
    once[k] = once[other];
    once[other] = static_cast<double>(k);
  }
  for (std::size_t k = 0; k < n; ++k) again[k] = once[k];
}

}  // namespace

void multi_jittered(std::span<double> x, std::span<double> y, Grid grid, Rng& rng) {
  require_grid(x, y, grid);
  const std::size_t nx = grid.nx, ny = grid.ny;
  // Memory on the stack: for few points, an allocation would cost more than everything else.
  std::array<double, 256> stack;
  std::array<std::size_t, 64> few_starts;
  std::vector<double> heap(2 * (nx + ny) > stack.size() ? 2 * (nx + ny) : 0);
  std::vector<std::size_t> many_starts(ny > few_starts.size() ? ny : 0);
  double* const in_column = heap.empty() ? stack.data() : heap.data();
  double* const in_row = in_column + 2 * ny;
  std::size_t* const starts = many_starts.empty() ? few_starts.data() : many_starts.data();
  Choices any(rng);
  permute_twice({in_column, 2 * ny}, any);
  permute_twice({in_row, 2 * nx}, any);
  for (std::size_t j = 0; j < ny; ++j) starts[j] = any.below(nx);
  uniforms(rng, x);
  uniforms(rng, y);
  const Strata all(x.size());
  for (std::size_t i = 0; i < nx; ++i) {  // column by column of cells
    double *const column_x = x.data() + i * ny, *const column_y = y.data() + i * ny;
    const double *const stratum = in_column + any.below(ny), *const in_rows = in_row + i;
    const auto first = static_cast<double>(i * ny);
    double row = 0;
    for (std::size_t j = 0; j < ny; ++j, row += static_cast<double>(nx)) {
      column_x[j] = all.place(first + stratum[j], column_x[j]);
      column_y[j] = all.place(row + in_rows[starts[j]], column_y[j]);
    }
  }
}

// 3.8 ---------------------------------------------------------------------------------------------

Estimate estimate_replicated(const Integrand& g, const Generator& generator, std::uint64_t n,
                             std::uint64_t replicates, Rng& rng) {
  if (n == 0) throw std::invalid_argument("n: must be positive");
  if (replicates == 0) throw std::invalid_argument("replicates: must be positive");
  PointSet points(n, g.dims);
  std::vector<double> point(g.dims);
  Moments means;  // of the replicates, which are independent; the points within one are not
  for (std::uint64_t replicate = 0; replicate < replicates; ++replicate) {
    generator(points, rng);
    Moments values;
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t d = 0; d < g.dims; ++d) point[d] = points.column(d)[i];
      add(values, g.f(point));
    }
    add(means, values.mean);
  }
  return {means.mean, std::sqrt(variance(means) / static_cast<double>(replicates)), n * replicates};
}

// 3.9 ---------------------------------------------------------------------------------------------

Estimate irradiance_stratified(const RectLight& light, Grid grid, std::uint64_t replicates,
                               Rng& rng) {
  if (grid.nx == 0 || grid.ny == 0) throw std::invalid_argument("grid: nx and ny must be positive");
  const double width = light.x1 - light.x0, depth = light.y1 - light.y0;
  const auto value = [&](std::span<const double> u) {  // that of 2.7
    const double x = light.x0 + width * u[0], y = light.y0 + depth * u[1];
    const double distance2 = x * x + y * y + light.height * light.height;
    const double cosines = light.height * light.height / distance2;  // equal at both ends
    return width * depth * light.radiance * cosines / distance2;
  };
  const auto jittered = [grid](PointSet& points, Rng& from) {
    stratified_2d(points.column(0), points.column(1), grid, from);
  };
  return estimate_replicated({2, value}, jittered, grid.nx * grid.ny, replicates, rng);
}

}  // namespace mc
