// Lab 3 · stratification: the reference solution. Speed tasks have their definitions
// first, then a faster version with the reason why it is faster.

#include "stratification.hpp"
#include "common/choices.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory_resource>
#include <numeric>
#include <stdexcept>
#include <vector>

namespace mc {

// 3.9 ---------------------------------------------------------------------------------------------

namespace definition {
/// Maps u in [0, 1) to stratum i of n. Sum and quotient may be rounded up to the upper edge of the
/// stratum; the result is then the double just below it.
double in_stratum(std::size_t i, std::size_t n, double u) {
  const auto stratum = static_cast<double>(i), strata = static_cast<double>(n);
  return std::min((stratum + u) / strata, std::nextafter((stratum + 1) / strata, 0.0));
}
}  // namespace definition

// The definition needs two divisions and, in 3.1 and 3.3, one call of the generator per number, one
// after the other. Here nothing is divided or clamped, and no number waits for another:
//
// * The jitter keeps away from both edges of its stratum, by 2^-50 of the whole axis: more than all
//   rounding errors together. So no value reaches an edge, and the rounded factor 1/n is accurate
//   enough.
// * Random numbers are drawn many at a time (2.8), in blocks that stay in the first-level cache
//   until they have been moved to their strata.
// * A stratum's number is an int within its block: vector registers convert those to double.

namespace {

constexpr std::size_t block_size = 1024;  // 8 KB

/// The n strata of [0,1).
class Strata {
 public:
  explicit Strata(std::size_t n)
      : margin_(static_cast<double>(n) * 0x1p-50),
        scale_(1 - 2 * margin_),
        width_(1 / static_cast<double>(n)) {}

  /// Maps u in [0,1) to stratum i. Jitter, sum, width, product, and the edge
  /// that it must not reach, are rounded by 2^-53 of the axis each, at most: 5 of the margin's 8.
  double place(double i, double u) const { return (i + (margin_ + scale_ * u)) * width_; }

 private:
  double margin_, scale_, width_;  // the first two in strata, the last one of [0,1)
};

/// Moves the values of `u`, in [0,1), to the strata first, first + 1, …
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
  if (n == 0) throw std::invalid_argument("n: there are no strata");
  auto ny = static_cast<std::size_t>(std::sqrt(static_cast<double>(n)));
  while (n % ny != 0) --ny;  // 1 divides everything
  return {n / ny, ny};
}

// 3.3 ---------------------------------------------------------------------------------------------

namespace {

void require_grid(std::span<const double> x, std::span<const double> y, Grid grid) {
  if (x.size() != y.size()) throw std::invalid_argument("x and y: sizes differ");
  if (grid.nx == 0 || grid.ny == 0) throw std::invalid_argument("grid: it has no cells");
  // Do not compare with the product: it may overflow 64 bits and look right.
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
  std::size_t column = 0, row = 0;  // of the next cell: they come row by row
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

/// Puts n things into random order, by `swap` of two of their numbers: which of the first n comes
/// last, which of the others before it, and so on. Choices are made ahead of the swaps: where
/// things are too many for a cache, a processor fetches many of them at a time.
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
  double* const x = values.data();  // a span's index may be checked, one by one
  shuffle_by([x](std::size_t i, std::size_t j) { std::swap(x[i], x[j]); }, values.size(), rng);
}

void stratified(PointSet& points, Rng& rng) {
  const std::size_t n = points.size(), odd = points.dims() % 2;
  for (std::size_t d = 0; d + odd < points.dims(); d += 2) {
    const auto x = points.column(d), y = points.column(d + 1);
    stratified_2d(x, y, strata(n), rng);
    const auto swap = [&](std::size_t i, std::size_t j) {  // pairs stay together
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
  if (per_axis == 0) throw std::invalid_argument("per_axis: there are no strata");
  std::size_t rest = points.size();  // divided, since the power may be too large for 64 bits
  bool divides = true;
  for (std::size_t d = 0; d < points.dims(); ++d) {
    divides = divides && rest % per_axis == 0;
    rest /= per_axis;
  }
  if (!divides || rest != 1) {
    throw std::invalid_argument("per_axis: per_axis^dims is not the number of points");
  }

  // Point k lies in cell k: its stratum along axis d is digit d of k in base per_axis, which stays
  // for per_axis^d points and then moves on.
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

// A column of cells has ny of the N strata of x, one per cell, assigned by a random permutation for
// each column. A row of cells has nx strata of y, assigned in the same way.
//
// That is N random numbers for each axis. If all columns share one permutation (Kensler 2013), all
// points of a row lie at the same place in their cells: their errors add up and fall as N^-3/4
// instead of N^-1. So let each column begin the shared permutation at a random place. Then any two
// points lie as they would with independent permutations (in one column: as two entries of a
// random permutation; in two columns: independently), and the variance of an estimate, which is
// made of pairs, is the same for every integrand, for the price of one number per column.
// docs/multi-jittered.md has the proof.

namespace {

/// A random permutation of 0 … n-1, twice, so that it may begin at any of its first n entries.
void permute_twice(std::span<double> order, Rng& rng) {
  const auto once = order.first(order.size() / 2);
  std::iota(once.begin(), once.end(), 0.0);
  shuffle(once, rng);
  for (std::size_t i = 0; i < once.size(); ++i) order[once.size() + i] = once[i];
}

}  // namespace

void multi_jittered(std::span<double> x, std::span<double> y, Grid grid, Rng& rng) {
  require_grid(x, y, grid);
  const std::size_t nx = grid.nx, ny = grid.ny;
  // On the stack where they are few: few points cost no more than a piece of memory does.
  std::array<std::byte, 2048> stack;
  std::pmr::monotonic_buffer_resource memory(stack.data(), stack.size());
  std::pmr::vector<double> in_column(2 * ny, &memory), in_row(2 * nx, &memory);
  permute_twice(in_column, rng);
  permute_twice(in_row, rng);
  std::pmr::vector<std::size_t> row_begins(ny, &memory);
  Choices any(rng);
  for (std::size_t& begin : row_begins) begin = any.below(nx);
  uniforms(rng, x);
  uniforms(rng, y);
  const Strata all(x.size());
  const std::size_t* const begins = row_begins.data();
  for (std::size_t i = 0; i < nx; ++i) {  // column by column of cells
    double *const column_x = x.data() + i * ny, *const column_y = y.data() + i * ny;
    const double* const stratum = in_column.data() + any.below(ny);
    const auto first = static_cast<double>(i * ny);
    for (std::size_t j = 0; j < ny; ++j) column_x[j] = all.place(first + stratum[j], column_x[j]);
    const double* const in_rows = in_row.data() + i;
    for (std::size_t j = 0; j < ny; ++j) {
      const auto row = static_cast<double>(static_cast<std::int64_t>(j * nx));
      column_y[j] = all.place(row + in_rows[begins[j]], column_y[j]);
    }
  }
}

// 3.8 ---------------------------------------------------------------------------------------------

Estimate estimate_replicated(const Integrand& g, const Generator& generator, std::uint64_t n,
                             std::uint64_t replicates, Rng& rng) {
  if (n == 0) throw std::invalid_argument("n: there are no points");
  if (replicates == 0) throw std::invalid_argument("replicates: there are none");
  PointSet points(n, g.dims);
  std::vector<double> point(g.dims);
  Moments means;  // of the replicates: their means are independent, the points in them are not
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

}  // namespace mc
