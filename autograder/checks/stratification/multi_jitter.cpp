// 3.7: strata of the plane and of both axes at once.

#include "checks/stratification/grids.hpp"
#include "checks/stratification/levels.hpp"
#include "checks/support/catch.hpp"
#include "checks/support/strata.hpp"

namespace mc::checks {
namespace {

Sets multi_jittered(Rng& rng, Grid grid, std::size_t sets) {
  return planes_of(MEASURE(multi_jittered, grid, sets, fresh_seed(rng)), grid, sets);
}

CHECK_CASE("3.7 strata of the plane and of both axes at once", "[3.7][main][points:5]") {
  Rng rng = check_rng();
  for (const Grid grid : {Grid{8, 8}, Grid{16, 4}, Grid{3, 5}, Grid{2 + rng() % 30, 2 + rng() % 30},
                          Grid{7, 1}, Grid{1, 11}, Grid{101, 1}, Grid{1, 1}}) {
    const std::size_t n = grid.nx * grid.ny;
    const Sets got = multi_jittered(rng, grid, 3);
    for (std::size_t set = 0; set < 3; ++set) {
      const View x = got.column(set, 0), y = got.column(set, 1);
      expect_one_in_each_cell(got.call, x, y, grid);
      const std::string elsewhere =
          "a column of cells has ny strata of x, one for each of its cells; a row nx of y";
      expect_one_in_each(got.call, "x", x, n, elsewhere);
      expect_one_in_each(got.call, "y", y, n, elsewhere);
    }
    if (grid.nx == 8 && grid.ny == 8) {
      expect_drawn_afresh(got, multi_jittered(rng, grid, 1), std::array{n, n});
    }
  }
}

/// Points of one set may share a permutation, so a set counts once: with one cell, the same in all
/// sets, and the one of its ny x nx parts that its point lies in.
void expect_uniform_in_cell(Rng& rng, Grid grid) {
  const std::size_t n = grid.nx * grid.ny;
  const Sets got = multi_jittered(rng, grid, 8000);
  const std::size_t cell = rng() % n;
  std::vector<std::uint64_t> counts(n);
  std::size_t along_x = 0, along_y = 0;  // points in the parts where the canonical arrangement is
  for (std::size_t set = 0; set < got.size(); ++set) {
    const View x = got.column(set, 0), y = got.column(set, 1);
    const auto cells = expect_one_in_each_cell(got.call, x, y, grid);
    const auto k =
        static_cast<std::size_t>(std::find(cells.begin(), cells.end(), cell) - cells.begin());
    const auto part_x =
        static_cast<std::size_t>(jitter_of(x[k], grid.nx) * static_cast<double>(grid.ny));
    const auto part_y =
        static_cast<std::size_t>(jitter_of(y[k], grid.ny) * static_cast<double>(grid.nx));
    ++counts[part_x * grid.nx + part_y];
    along_x += part_x == cell / grid.nx;
    along_y += part_y == cell % grid.nx;
  }
  const bool x_stays = along_x == got.size(), y_stays = along_y == got.size();
  const double each = 1 / static_cast<double>(n);
  expect_counts(
      fmt::format("{}, points in the {} x {} parts of cell ({}, {})", got.call, grid.ny, grid.nx,
                  cell % grid.nx, cell / grid.nx),
      counts, std::span(&each, 1),
      {fmt::format("a point of {} x {} cells lies in any of the parts of its cell", grid.nx,
                   grid.ny),
       alpha},
      {{},
       x_stays && y_stays
           ? "this is the canonical arrangement, which is biased: permute at random which cell of "
             "a column takes which stratum of x, and which cell of a row takes which stratum of y"
       : y_stays ? "x is shuffled and y is not: permute at random which cell of a row takes which "
                   "stratum of y"
       : x_stays ? "y is shuffled and x is not: permute at random which cell of a column takes "
                   "which stratum of x"
                 : "random permutations, all of them equally likely, give the strata of x to the "
                   "cells of each column, and the strata of y to the cells of each row"});
}

CHECK_CASE("3.7 each point is uniform in its cell", "[3.7][points:4][needs:3.4]") {
  Rng rng = check_rng();
  expect_uniform_in_cell(rng, {4, 3});
  expect_uniform_in_cell(rng, {3, 3});  // where one permutation would do for both
}

CHECK_CASE("3.7 each point is uniform in its strata of x and y", "[3.7][points:1]") {
  Rng rng = check_rng();
  constexpr Grid grid{4, 3};
  constexpr std::size_t n = grid.nx * grid.ny, sets = 6000;
  const Sets got = multi_jittered(rng, grid, sets);
  const Values u = jitters_of(got, 0, n), v = jitters_of(got, 1, n);
  expect_independent(got.call, u, v, "the points of 3.7 are uniform in their strata of x and y",
                     "the same random number moves x and y");
  // Strata side by side, on either axis.
  for (const std::size_t d : {0u, 1u}) {
    const char* const axis = d == 0 ? "x" : "y";
    Values here, there;
    for (std::size_t set = 0; set < sets; ++set) {
      const View column = got.column(set, d);
      expect_one_in_each(got.call, axis, column, n, "see the main check of 3.7");
      Values by_stratum(n);
      for (const double value : column) by_stratum[*stratum_of(value, n)] = jitter_of(value, n);
      for (std::size_t i = 0; i < n; ++i) (i % 2 == 0 ? here : there).push_back(by_stratum[i]);
    }
    expect_independent(got.call, here, there,
                       fmt::format("strata of {} side by side are independent in 3.7", axis),
                       one_for_all);
    expect_fine(fmt::format("{}, {}", got.call, axis), d == 0 ? u : v, n);
  }
}

CHECK_CASE("3.7 a sum is estimated as in one dimension", "[3.7][points:1]") {
  Rng rng = check_rng();
  const auto axis = strata_of(exponential, 64);
  auto expected = expected_of(axis);  // twice, independent: one x in each of 64 strata, one y too
  expected.mean *= 2, expected.variance *= 2, expected.independent *= 2;
  expect_level(multi_jittered(rng, {8, 8}, 1000), sum_over_axes("exp(x) + exp(y)", exponential),
               expected, "estimates of exp(x) + exp(y) have the variance of two 1D patterns",
               "every one of the N strata of x has one point, and every one of y");
}

Call into_multi(std::uint64_t size_x, std::uint64_t size_y, Grid grid) {
  return MEASURE_OUTCOME(multi_jittered_into, size_x, size_y, grid);
}

CHECK_CASE("3.7 what is no grid of these points is refused", "[3.7][edge][points:0.5]") {
  expect_refused(wrong_grids(into_multi));
}

CHECK_CASE("3.7 the refusals name the argument", "[3.7][edge][points:0.5]") {
  expect_argument_named(wrong_grids(into_multi));
}

}  // namespace
}  // namespace mc::checks
