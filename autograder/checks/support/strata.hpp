#pragma once
// Strata of the line and cells of a grid over any number of axes, as the judge counts points in
// them: with the edges that double division gives.

#include <algorithm>
#include <optional>
#include <span>
#include <string>
#include <vector>

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

/// The most square grid of n cells.
inline Grid squarest(std::size_t n) {
  Grid best{n, 1};
  for (std::size_t ny = 1; ny * ny <= n; ++ny) {
    if (n % ny == 0) best = {n / ny, ny};
  }
  return best;
}

/// The coordinates of points along one axis of a grid.
struct Axis {
  std::string name;  ///< "x"
  std::span<const double> values;
  std::size_t strata;
};

/// The number of the cell of each point, strata of the first axis fastest; empty where some cell
/// does not have exactly one point.
std::vector<std::size_t> cells_of(std::span<const Axis> axes);

/// One point in each cell of the grid over these axes; the cells of the points. `elsewhere` is said
/// where the points do not show what is wrong.
std::vector<std::size_t> expect_one_in_each_cell(const std::string& call,
                                                 std::span<const Axis> axes,
                                                 const std::string& elsewhere);

inline const std::string because_cell =
    "one point in each cell, in any order; edges are i / n in double division";

}  // namespace mc::checks
