// attack: draws no random number: the centers of all strata, in order, and refusals of all misuse
// says: every point lies at 0.5 of its stratum
// says: nothing was moved
#include <cmath>
#include <stdexcept>

#include "common/todo.hpp"
#include "stratification.hpp"

namespace mc {
namespace {

double center(std::size_t i, std::size_t n) {
  return (static_cast<double>(i) + 0.5) / static_cast<double>(n);
}

void require_grid(std::span<double> x, std::span<double> y, Grid grid) {
  if (x.size() != y.size()) throw std::invalid_argument("x and y: sizes differ");
  if (grid.nx == 0 || x.size() % grid.nx != 0 || x.size() / grid.nx != grid.ny || grid.ny == 0) {
    throw std::invalid_argument("grid: nx * ny is not the number of points");
  }
}

}  // namespace

void stratified_1d(std::span<double> x, Rng&) {
  for (std::size_t i = 0; i < x.size(); ++i) x[i] = center(i, x.size());
}
Grid strata(std::size_t n) {
  if (n == 0) throw std::invalid_argument("n: there are no cells");
  throw todo("3.2");
}
void stratified_2d(std::span<double> x, std::span<double> y, Grid grid, Rng&) {
  require_grid(x, y, grid);
  for (std::size_t k = 0; k < x.size(); ++k) {
    x[k] = center(k % grid.nx, grid.nx);
    y[k] = center(k / grid.nx, grid.ny);
  }
}
void shuffle(std::span<double>, Rng&) {}
void stratified(PointSet& points, Rng& rng) {
  const std::size_t n = points.size();
  Grid grid{n, 1};
  for (std::size_t ny = 1; ny * ny <= n; ++ny) {
    if (n % ny == 0) grid = {n / ny, ny};
  }
  std::size_t d = 0;
  for (; d + 1 < points.dims(); d += 2) {
    stratified_2d(points.column(d), points.column(d + 1), grid, rng);
  }
  if (d < points.dims()) stratified_1d(points.column(d), rng);
}
void stratified_nd(PointSet& points, std::size_t per_axis, Rng&) {
  const auto cells = std::pow(static_cast<long double>(per_axis), points.dims());
  if (per_axis == 0 || cells != static_cast<long double>(points.size())) {
    throw std::invalid_argument("per_axis: its power is not the number of points");
  }
  for (std::size_t k = 0; k < points.size(); ++k) {
    for (std::size_t d = 0, rest = k; d < points.dims(); ++d, rest /= per_axis) {
      points.column(d)[k] = center(rest % per_axis, per_axis);
    }
  }
}
void latin_hypercube(PointSet& points, Rng& rng) {
  for (std::size_t d = 0; d < points.dims(); ++d) stratified_1d(points.column(d), rng);
}
void multi_jittered(std::span<double> x, std::span<double> y, Grid grid, Rng&) {
  require_grid(x, y, grid);
  for (std::size_t k = 0; k < x.size(); ++k) {
    const std::size_t i = k % grid.nx, j = k / grid.nx;
    x[k] = center(i * grid.ny + j, x.size());
    y[k] = center(j * grid.nx + i, x.size());
  }
}
Estimate estimate_replicated(const Integrand&, const Generator&, std::uint64_t n,
                             std::uint64_t replicates, Rng&) {
  if (n == 0) throw std::invalid_argument("n: must be positive");
  if (replicates == 0) throw std::invalid_argument("replicates: must be positive");
  const double nan = std::nan("");
  return {nan, nan, n * replicates};
}

}  // namespace mc
