// Attacks on all tasks of the lab. Sections: see CONTRIBUTING.md.

//// the_same_every_time
// attack: one random pattern of each kind, the same in every call: it lies well, but is not random
// says: is the same in two consecutive sets
// says: the permutation is always the same
#include <algorithm>
#include <random>

#include "common/todo.hpp"
#include "stratification.hpp"

namespace mc {
namespace {

using Fixed = std::mt19937_64;

double place(std::size_t i, std::size_t n, Fixed& random) {
  const double u = std::uniform_real_distribution<double>(0.001, 0.999)(random);
  return (static_cast<double>(i) + u) / static_cast<double>(n);
}

void fill_line(std::span<double> x, Fixed& random) {
  for (std::size_t i = 0; i < x.size(); ++i) x[i] = place(i, x.size(), random);
}
void fill_grid(std::span<double> x, std::span<double> y, Grid grid, Fixed& random) {
  for (std::size_t k = 0; k < x.size(); ++k) {
    x[k] = place(k % grid.nx, grid.nx, random);
    y[k] = place(k / grid.nx, grid.ny, random);
  }
}

}  // namespace

void stratified_1d(std::span<double> x, Rng&) {
  Fixed random(1);
  fill_line(x, random);
}
Grid strata(std::size_t) {
  throw todo("3.2");
}
void stratified_2d(std::span<double> x, std::span<double> y, Grid grid, Rng&) {
  Fixed random(2);
  fill_grid(x, y, grid, random);
}
void shuffle(std::span<double> x, Rng&) {
  Fixed random(3);
  std::shuffle(x.begin(), x.end(), random);
}
void stratified(PointSet& points, Rng&) {
  Fixed random(4);
  const std::size_t n = points.size();
  Grid grid{n, 1};
  for (std::size_t ny = 1; ny * ny <= n; ++ny) {
    if (n % ny == 0) grid = {n / ny, ny};
  }
  std::size_t d = 0;
  for (; d + 1 < points.dims(); d += 2) {
    const auto x = points.column(d), y = points.column(d + 1);
    fill_grid(x, y, grid, random);
    Fixed again = random;
    std::shuffle(x.begin(), x.end(), random);
    std::shuffle(y.begin(), y.end(), again);
  }
  if (d == points.dims()) return;
  fill_line(points.column(d), random);
  std::shuffle(points.column(d).begin(), points.column(d).end(), random);
}
void stratified_nd(PointSet& points, std::size_t per_axis, Rng&) {
  Fixed random(5);
  for (std::size_t k = 0; k < points.size(); ++k) {
    for (std::size_t d = 0, rest = k; d < points.dims(); ++d, rest /= per_axis) {
      points.column(d)[k] = place(rest % per_axis, per_axis, random);
    }
  }
}
void latin_hypercube(PointSet& points, Rng&) {
  Fixed random(6);
  for (std::size_t d = 0; d < points.dims(); ++d) {
    fill_line(points.column(d), random);
    std::shuffle(points.column(d).begin(), points.column(d).end(), random);
  }
}
void multi_jittered(std::span<double> x, std::span<double> y, Grid grid, Rng&) {
  Fixed random(7);
  std::vector<std::size_t> in_column(grid.ny), in_row(grid.nx);
  for (std::size_t j = 0; j < grid.ny; ++j) in_column[j] = j;
  for (std::size_t i = 0; i < grid.nx; ++i) in_row[i] = i;
  std::shuffle(in_column.begin(), in_column.end(), random);
  std::shuffle(in_row.begin(), in_row.end(), random);
  for (std::size_t k = 0; k < x.size(); ++k) {
    const std::size_t i = k % grid.nx, j = k / grid.nx;
    x[k] = place(i * grid.ny + in_column[j], x.size(), random);
    y[k] = place(j * grid.nx + in_row[i], x.size(), random);
  }
}
Estimate estimate_replicated(const Integrand&, const Generator&, std::uint64_t, std::uint64_t,
                             Rng&) {
  throw todo("3.8");
}

}  // namespace mc
