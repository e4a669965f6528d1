#pragma once
// Grids: the most square one, and what is none for the points given.

#include <vector>

#include "checks/support/refusals.hpp"
#include "common/points.hpp"

namespace mc::checks {

/// Of n cells.
inline Grid squarest(std::size_t n) {
  Grid best{n, 1};
  for (std::size_t ny = 1; ny * ny <= n; ++ny) {
    if (n % ny == 0) best = {n / ny, ny};
  }
  return best;
}

using IntoGrid = Call(std::uint64_t size_x, std::uint64_t size_y, Grid grid);

/// What both tasks that fill a grid refuse. nx * ny wraps around to 4 in the last one.
inline std::vector<InvalidCall> wrong_grids(IntoGrid into) {
  const std::string grid = "grid|nx|ny", sizes = "x|y|size";
  return {
      {into(6, 5, {3, 2}), sizes, "x and y are the coordinates of the same points"},
      {into(5, 6, {3, 2}), sizes, "x and y are the coordinates of the same points"},
      {into(6, 6, {3, 3}), grid, "six points do not fill nine cells"},
      {into(6, 6, {2, 2}), grid, "four cells do not hold six points"},
      {into(0, 0, {0, 5}), grid, "a grid has cells"},
      {into(0, 0, {5, 0}), grid, "a grid has cells"},
      {into(0, 0, {0, 0}), grid, "a grid has cells"},
      {into(4, 4, {(std::uint64_t{1} << 62) + 1, 4}), grid, "nx * ny = 2^64 + 4, which is not 4",
       "the product of 64-bit numbers wraps around and gives 4: divide instead"}};
}

}  // namespace mc::checks
