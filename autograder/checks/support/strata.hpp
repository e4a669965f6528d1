#pragma once
// Strata of the line and cells of the plane, as the judge counts points in them: with the edges
// that double division gives.

#include <algorithm>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "checks/support/expect.hpp"
#include "common/points.hpp"

namespace mc::checks {

/// The stratum i of n with double(i) / n <= x < double(i+1) / n; nothing outside [0,1).
inline std::optional<std::size_t> stratum_of(double x, std::size_t n) {
  if (!(x >= 0 && x < 1)) return {};
  const auto size = static_cast<double>(n);
  auto i = std::min(static_cast<std::size_t>(x * size), n - 1);  // rounded: right, or one off
  while (x < static_cast<double>(i) / size) --i;
  while (x >= static_cast<double>(i + 1) / size) ++i;
  return i;
}

inline void expect_inside(const std::string& call, const char* axis, std::span<const double> x) {
  for (std::size_t k = 0; k < x.size(); ++k) {
    if (x[k] >= 0 && x[k] < 1) continue;
    expect_that(false, fmt::format("{}: {}[{}] = {}", call, axis, k, x[k]), "values in [0, 1)",
                "points lie in the unit cube, which does not contain its upper faces",
                x[k] == 1 ? "it was rounded up to 1: hold it below the upper edge of its stratum"
                          : "divide by the number of strata");
  }
}

/// One point in each of n strata. What `elsewhere` says is likely, where nothing better is known.
inline void expect_one_in_each(const std::string& call, const char* axis, std::span<const double> x,
                               std::size_t n, const std::string& elsewhere) {
  expect_inside(call, axis, x);
  std::vector<std::size_t> points(n);
  for (const double value : x) ++points[*stratum_of(value, n)];
  for (std::size_t i = 0; i < n; ++i) {
    if (points[i] == 1) continue;
    expect_that(false,
                fmt::format("{}: {} points with {} in [{}/{}, {}/{})", call, points[i], axis, i, n,
                            i + 1, n),
                fmt::format("one point in each of the {} strata of {}", n, axis),
                "that is what stratified means; edges are i / n in double division", elsewhere);
  }
  pass();
}

inline const std::string because_cell =
    "one point in each cell, in any order; edges are i / nx and j / ny in double division";

/// The cell of each point, as i + nx j; empty where some cell has not got exactly one.
inline std::vector<std::size_t> cells_of(std::span<const double> x, std::span<const double> y,
                                         Grid grid) {
  std::vector<std::size_t> cells;
  std::vector<bool> taken(grid.nx * grid.ny);
  for (std::size_t k = 0; k < x.size(); ++k) {
    const auto i = stratum_of(x[k], grid.nx), j = stratum_of(y[k], grid.ny);
    if (!i || !j || taken[*i + grid.nx * *j]) return {};
    taken[*i + grid.nx * *j] = true;
    cells.push_back(*i + grid.nx * *j);
  }
  return cells;
}

inline bool is_stratified(std::span<const double> x, std::size_t n) {
  return !cells_of(x, std::vector<double>(x.size()), {n, 1}).empty();
}

/// Whether each of `strata` has `each` points.
inline bool has_each(std::span<const double> x, std::size_t strata, std::size_t each) {
  std::vector<std::size_t> points(strata);
  for (const double value : x) ++points[*stratum_of(value, strata)];
  return std::all_of(points.begin(), points.end(), [=](auto count) { return count == each; });
}

/// One point in each cell of a grid; gives back which point is in which.
inline std::vector<std::size_t> expect_one_in_each_cell(const std::string& call,
                                                        std::span<const double> x,
                                                        std::span<const double> y, Grid grid) {
  if (x.size() != grid.nx * grid.ny || y.size() != x.size()) {
    fail(fmt::format("measured  {}: {} x and {} y", call, x.size(), y.size()));
  }
  expect_inside(call, "x", x);
  expect_inside(call, "y", y);
  auto cells = cells_of(x, y, grid);
  if (!cells.empty()) {
    pass();
    return cells;
  }
  std::vector<std::size_t> points(grid.nx * grid.ny);
  for (std::size_t k = 0; k < x.size(); ++k) {
    ++points[*stratum_of(x[k], grid.nx) + grid.nx * *stratum_of(y[k], grid.ny)];
  }
  const auto cell = static_cast<std::size_t>(
      std::find_if(points.begin(), points.end(), [](auto count) { return count != 1; }) -
      points.begin());
  const std::size_t n = x.size();
  expect_that(
      false,
      fmt::format("{}: {} points in cell ({}, {}) of {} x {}", call, points[cell], cell % grid.nx,
                  cell / grid.nx, grid.nx, grid.ny),
      "one point", because_cell,
      // a few points fit by chance, a dozen once in 1e4
      n >= 12 && grid.nx != grid.ny && !cells_of(x, y, {grid.ny, grid.nx}).empty()
          ? "nx and ny have changed places: nx cells along x, ny along y"
      : n >= 4 && points[0] == n
          ? "every point lies in cell (0, 0): i / nx of two whole numbers is 0"
      : is_stratified(x, n) && is_stratified(y, n)
          ? "each axis is stratified, the plane is left to chance: two 1D patterns are not a 2D "
            "pattern, nor is one whose x and y were shuffled apart"
      : n >= 12 && grid.nx > 1 && grid.ny > 1 && has_each(x, grid.nx, grid.ny) &&
              has_each(y, grid.ny, grid.nx)
          ? "each row and each column of cells has its points, but not each cell: x and y of a "
            "point belong together, and are shuffled together"
          : "each cell (i, j) gets one point, ((i + u) / nx, (j + v) / ny)");
  return {};
}

}  // namespace mc::checks
