#pragma once
// What several tasks of lab 3 share: the claims about jitter, grids, and calls that are refused.

#include <vector>

#include <fmt/format.h>

#include "3-stratification/experiments.hpp"
#include "checks/support/data.hpp"
#include "checks/support/domain.hpp"
#include "checks/support/refusals.hpp"
#include "checks/support/sample_sets.hpp"
#include "checks/support/strata.hpp"
#include "common/points.hpp"

namespace mc::checks {

using Sets = SampleSets;

/// Of every random test of lab 3. There are 100 of them at most, so that a right answer fails once
/// in two million runs.
constexpr double alpha = 5e-9;

/// Short enough to be typed again.
inline std::uint64_t fresh_seed(Rng& rng) {
  return rng() >> 32;
}

/// Jitters of task `task` are independent and uniform.
inline Randomness random_jitters(const std::string& task) {
  return {.words = "points are uniform in the cells of " + task + ", and independent",
          .alpha = alpha,
          .otherwise = "each point is (i + u) / n with a u of its own, uniform in [0, 1)",
          .repeated =
              "the same random numbers come again and again, as where each block begins with the "
              "same ones, or streams that run side by side are copies of each other: draw one "
              "for every coordinate, all from the generator that is passed in",
          .same = "the same random number moves both: draw one for every coordinate"};
}

/// A grid that columns 0 and 1 fill, and n strata of one column.
inline Pattern plane_of(Grid grid) {
  return {{0, 1}, {grid.nx, grid.ny}};
}
inline Pattern line_of(std::size_t n, std::size_t d = 0) {
  return {{d}, {n}};
}

using IntoGrid = Call(std::uint64_t size_x, std::uint64_t size_y, Grid grid);

/// What both tasks that fill a grid refuse. nx * ny wraps around to 4 and to 0 in the last ones.
inline std::vector<InvalidCall> wrong_grids(IntoGrid into) {
  const std::string grid = "grid|nx|ny", sizes = "x|y|size";
  const std::string wraps = "the product of 64-bit numbers wraps around: divide instead";
  const std::uint64_t half = std::uint64_t{1} << 32;
  return {{into(6, 5, {3, 2}), sizes, "x and y are the coordinates of the same points"},
          {into(5, 6, {3, 2}), sizes, "x and y are the coordinates of the same points"},
          {into(6, 0, {3, 2}), sizes, "x and y are the coordinates of the same points"},
          {into(6, 6, {3, 3}), grid, "six points do not fill nine cells"},
          {into(6, 6, {2, 2}), grid, "four cells do not hold six points"},
          {into(6, 6, {6, 2}), grid, "six points do not fill twelve cells"},
          {into(6, 6, {4, 1}), grid, "four cells do not hold six points"},
          {into(0, 0, {0, 5}), grid, "a grid has cells"},
          {into(0, 0, {5, 0}), grid, "a grid has cells"},
          {into(0, 0, {0, 0}), grid, "a grid has cells"},
          {into(0, 0, {1, 1}), grid, "no points do not fill a cell"},
          {into(6, 6, {0, 6}), grid, "a grid has cells"},
          {into(6, 6, {6, 0}), grid, "a grid has cells"},
          {into(4, 4, {(std::uint64_t{1} << 62) + 1, 4}), grid, "nx * ny = 2^64 + 4, not 4", wraps},
          {into(4, 4, {4, (std::uint64_t{1} << 62) + 1}), grid, "nx * ny = 2^64 + 4, not 4", wraps},
          {into(0, 0, {half, half}), grid, "nx * ny = 2^64, not 0", wraps}};
}

}  // namespace mc::checks
