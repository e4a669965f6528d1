#pragma once
// Multi-jittered points, as 6.2 asks for them, and 6.7 of every next2() but the first.

#include <algorithm>

#include "checks/sampler/samplers.hpp"
#include "checks/support/strata.hpp"

namespace mc::checks {

/// nx ny = n, nx >= ny, as square as n allows.
inline Grid grid_of(std::size_t n) {
  std::size_t ny = 1;
  for (std::size_t divisor = 1; divisor * divisor <= n; ++divisor) {
    if (n % divisor == 0) ny = divisor;
  }
  return {n / ny, ny};
}

/// One point in each cell of strata(N), and one in each of N strata on either axis.
inline void check_multi_jittered(const std::string& call, View x, View y) {
  const std::size_t n = x.size();
  const Grid grid = grid_of(n);
  const bool has_cells = !cells_of(x, y, grid).empty();
  if (has_cells || !is_stratified(x, n) || !is_stratified(y, n)) {
    expect_one_in_each_cell(call, x, y, grid);
    const std::string jittered =
        "a jittered grid has one point in each cell; multi-jittered points (3.7) have one in "
        "each stratum of either axis too";
    expect_one_in_each(call, "x", x, n, jittered);
    expect_one_in_each(call, "y", y, n, jittered);
    return;
  }
  expect_that(false,
              fmt::format("{}: one point in each of {} strata of x and of y, and not in each of "
                          "{} x {} cells",
                          call, n, grid.nx, grid.ny),
              "one point in each cell too", because_cell,
              "two 1D patterns are not a 2D pattern; and multi-jittered points are none any more "
              "when x and y are shuffled apart: pairs stay together");
}

}  // namespace mc::checks
