#pragma once
// The points of lab 5's plots, by their columns; nothing where a task is missing.

#include <algorithm>
#include <array>
#include <numeric>
#include <optional>
#include <string>
#include <vector>

#include "5-halton/experiments.hpp"
#include "checks/support/data.hpp"
#include "measurements/halton/measured_columns.hpp"

namespace mc::checks {

using Number = std::optional<double>;
using Points = std::optional<std::vector<std::vector<double>>>;

inline Points joined(const std::vector<Column>& columns) {
  std::vector<std::vector<double>> points;
  for (const Column& column : columns) {
    if (!column) return {};
    points.push_back(*column);
  }
  return points;
}

/// A list of columns of n values, one after the other, taken apart.
inline Points columns_of(const Column& all, std::size_t n) {
  if (!all) return {};
  std::vector<std::vector<double>> points;
  for (std::size_t at = 0; at < all->size(); at += n) {
    const auto from = all->begin() + static_cast<std::ptrdiff_t>(at);
    points.emplace_back(from, from + static_cast<std::ptrdiff_t>(n));
  }
  return points;
}

inline Points random_points(Rng& rng, std::size_t n, std::size_t dims) {
  std::vector<std::vector<double>> points;
  while (points.size() < dims) points.push_back(uniform_values(rng, n, 0, 1));
  return points;
}

/// One point in each stratum of the line, in each cell of the squarest grid of n = 2^k cells in the
/// plane; in four dimensions two such grids side by side, each in an order of its own.
inline Points stratified_points(Rng& rng, std::size_t n, std::size_t dims) {
  std::size_t nx = 1;
  while (nx * nx < n) nx *= 2;
  if (dims == 1) nx = n;
  const std::size_t ny = n / nx;
  std::vector<std::vector<double>> points(dims, std::vector<double>(n));
  std::vector<std::size_t> order(n);
  for (std::size_t d = 0; d < dims; d += 2) {
    std::iota(order.begin(), order.end(), std::size_t{0});
    if (dims > 2) std::shuffle(order.begin(), order.end(), rng);
    for (std::size_t i = 0; i < n; ++i) {
      const auto along = [&](std::size_t cell, std::size_t cells) {
        return (static_cast<double>(cell) + uniform(rng)) / static_cast<double>(cells);
      };
      points[d][i] = along(order[i] % nx, nx);
      if (d + 1 < dims) points[d + 1][i] = along(order[i] / nx, ny);
    }
  }
  return points;
}

inline Points halton_points(std::size_t n, std::size_t dims) {
  return columns_of(column_of(TRY_MEASURE(halton, n, dims, 0), n * dims), n);
}
inline Points hammersley_points(std::size_t n, std::size_t dims) {
  return columns_of(column_of(TRY_MEASURE(hammersley, n, dims), n * dims), n);
}
inline Points sobol_plot_points(std::size_t n, std::vector<unsigned> dimensions) {
  std::vector<Column> columns;
  for (const unsigned d : dimensions) columns.push_back(column_of(TRY_MEASURE(sobol, d, 0, n), n));
  return joined(columns);
}

/// Sets of scrambled points, by seeds of their own: [set][dimension].
inline std::vector<Points> scrambled_sets_of(const Points& points, std::size_t sets,
                                             std::uint64_t seed) {
  std::vector<Points> all(sets);
  if (!points) return all;
  for (Points& set : all) set.emplace();
  for (std::size_t d = 0; d < points->size(); ++d) {
    const auto& column = (*points)[d];
    std::vector<std::uint64_t> seeds(sets);
    std::iota(seeds.begin(), seeds.end(), seed + d * 1000000);
    const std::size_t count = column.size() * sets;
    const Points scrambled =
        columns_of(column_of(TRY_MEASURE(owen_scramble, column, seeds), count), column.size());
    if (!scrambled) return std::vector<Points>(sets);
    for (std::size_t set = 0; set < sets; ++set) all[set]->push_back((*scrambled)[set]);
  }
  return all;
}

inline void write_points(const std::string& name, const Points& points) {
  auto file = plot_file(name);
  if (!points) plot_row(file, std::array{Number{}, Number{}});
  if (points) {
    for (std::size_t i = 0; i < (*points)[0].size(); ++i) {
      plot_row(file, std::array{Number((*points)[0][i]), Number((*points)[1][i])});
    }
  }
}

}  // namespace mc::checks
