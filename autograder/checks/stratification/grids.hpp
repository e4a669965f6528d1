#pragma once
// Grids: the most square one, and what is none for the points given.

#include <vector>

#include "checks/stratification/refusals.hpp"
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

inline Misuse sizes_that_differ(IntoGrid into) {
  return {into(6, 5, {3, 2}), "x and y are the coordinates of the same points"};
}

/// nx * ny wraps around to 4 in the last one.
inline std::vector<Misuse> wrong_grids(IntoGrid into) {
  return {{into(6, 6, {3, 3}), "six points do not fill nine cells"},
          {into(6, 6, {2, 2}), "four cells do not hold six points"},
          {into(0, 0, {0, 5}), "a grid has cells"},
          {into(0, 0, {5, 0}), "a grid has cells"},
          {into(4, 4, {(std::uint64_t{1} << 62) + 1, 4}), "nx * ny = 2^64 + 4, which is not 4",
           "the product of 64-bit numbers wraps around and gives 4: divide instead"}};
}

/// What both tasks that fill a grid refuse.
inline std::vector<Misuse> grid_misuses(IntoGrid into) {
  std::vector<Misuse> all = wrong_grids(into);
  all.insert(all.begin(), sizes_that_differ(into));
  return all;
}

/// In words that say what is wrong: one of these, the others being refused or not.
inline void expect_grid_named(IntoGrid into) {
  const std::vector<Misuse> grids = wrong_grids(into);
  expect_named(grids, {"grid", "nx", "ny"});
  const Misuse sizes = sizes_that_differ(into);
  if (is_refused(sizes.call)) expect_named(std::span(&sizes, 1), {"x", "y", "size"});
}

}  // namespace mc::checks
