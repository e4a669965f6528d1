// 3.2 and 3.3: the grid of n cells, and one point in each of them.

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>

#include "checks/stratification/grids.hpp"
#include "checks/stratification/levels.hpp"
#include "checks/support/catch.hpp"
#include "checks/support/data.hpp"
#include "checks/support/strata.hpp"

namespace mc::checks {
namespace {

// 3.2 ---------------------------------------------------------------------------------------------

void expect_grids(const std::vector<std::uint64_t>& n) {
  const auto got = MEASURE(strata, n);
  const std::vector<Grid>& grids = got.exactly(n.size(), any_number);
  for (std::size_t k = 0; k < n.size(); ++k) {
    const Grid grid = grids[k], best = squarest(n[k]);
    expect_that(grid.nx == best.nx && grid.ny == best.ny,
                fmt::format("strata({}) = {} x {}", n[k], grid.nx, grid.ny),
                fmt::format("{} x {}", best.nx, best.ny),
                "nx * ny = n with nx >= ny, as close to each other as the factors of n allow",
                grid.nx == best.ny && grid.ny == best.nx ? "nx is the larger one"
                : grid.nx * grid.ny != n[k]
                    ? "nx * ny must be n: a stratum too few leaves points out"
                    : "ny is the largest divisor of n that is not above its square root");
  }
}

CHECK_CASE("3.2 the grid is as square as n allows", "[3.2][main][points:3]") {
  Rng rng = check_rng();
  std::vector<std::uint64_t> n(400);
  std::iota(n.begin(), n.end(), 1);
  std::rotate(n.begin(), n.begin() + 11, n.end());  // 12 first, the smallest ones last
  expect_grids(n);
  expect_grids({30030, 1u << 20, 1000000, 999999, 2 * 499979, 1009 * 1013, 2 + rng() % 1000000});
}

CHECK_CASE("3.2 a prime number of cells is a row", "[3.2][points:1]") {
  expect_grids({7, 101, 1009, 65537, 999983, 1000000007, 5, 3, 2});
}

std::vector<InvalidCall> no_cells() {
  return {{MEASURE_OUTCOME(strata, {0}), "n|strata|cell", "there is no grid without cells"}};
}

CHECK_CASE("3.2 n = 0 is refused", "[3.2][edge][points:0.5]") {
  expect_refused(no_cells());
}

CHECK_CASE("3.2 the refusal names the argument", "[3.2][edge][points:0.5]") {
  expect_argument_named(no_cells());
}

CHECK_CASE("3.2 more cells than 32 bits count", "[3.2][edge][points:1]") {
  // Squares, products of neighbours, what lies beside them. A loop over all numbers up to the
  // square root takes 30 ns each at worst: 0.1 s a call.
  Rng rng = check_rng();
  const std::uint64_t k = 66000 + rng() % 400000;
  for (const std::vector<std::uint64_t>& n :
       {std::vector<std::uint64_t>{k * k, k * (k + 1), k * k - 1},
        {std::uint64_t{1} << 40, 1000000000000}}) {
    const Call call = MEASURE_OUTCOME(strata, n);
    expect_that(!call.outcome.over_limit(), call.text + " did not end", "about sqrt(n) steps",
                "n has 64 bits", "k * k in 32 bits is never above such an n: make k a std::size_t");
    expect_grids(n);
  }
}

// 3.3 ---------------------------------------------------------------------------------------------

Sets jittered(Rng& rng, Grid grid, std::size_t sets) {
  return planes_of(MEASURE(stratified_2d, grid, sets, fresh_seed(rng)), grid, sets);
}

CHECK_CASE("3.3 one point in each cell", "[3.3][main][points:4]") {
  Rng rng = check_rng();
  for (const Grid grid :
       {Grid{16, 4}, Grid{8, 8}, Grid{3, 5}, Grid{100, 10}, Grid{2 + rng() % 50, 2 + rng() % 50},
        Grid{7, 1}, Grid{1, 11}, Grid{1, 1}}) {
    const Sets got = jittered(rng, grid, 3);
    for (std::size_t set = 0; set < 3; ++set) {
      expect_one_in_each_cell(got.call, got.column(set, 0), got.column(set, 1), grid);
    }
    if (grid.nx == 16)
      expect_drawn_afresh(got, jittered(rng, grid, 1), std::array{grid.nx, grid.ny});
  }
}

CHECK_CASE("3.3 each point is uniform in its cell", "[3.3][points:3]") {
  Rng rng = check_rng();
  const Sets got = jittered(rng, {5, 3}, 4400);
  const Values u = jitters_of(got, 0, 5), v = jitters_of(got, 1, 3);
  expect_fine(got.call + ", x", u, 5);
  expect_fine(got.call + ", y", v, 3);
  expect_independent(got.call, u, v, "the points of 3.3 are uniform in their cells",
                     "the same random number moves x and y: points lie on the cells' diagonals");
}

CHECK_CASE("3.3 the cells are independent of each other", "[3.3][points:3]") {
  Rng rng = check_rng();
  constexpr std::size_t side = 4, n = side * side, sets = 1000;
  const Sets got = jittered(rng, {side, side}, sets);
  Values u(n * sets), v(n * sets);  // by cell, row by row, in whatever order they came
  for (std::size_t set = 0; set < sets; ++set) {
    const auto x = got.column(set, 0), y = got.column(set, 1);
    const auto cells = expect_one_in_each_cell(got.call, x, y, {side, side});
    for (std::size_t k = 0; k < n; ++k) {
      u[set * n + cells[k]] = jitter_of(x[k], side);
      v[set * n + cells[k]] = jitter_of(y[k], side);
    }
  }
  // Each cell with its right-hand neighbour, with the one above it, with itself one set later; no
  // cell in two pairs of a kind.
  const auto expect_pairs = [&](std::size_t apart, const std::string& words) {
    Values u_here, u_there, v_here, v_there;
    for (std::size_t k = 0; k < n * sets; ++k) {
      if (k / apart % 2 == 1) continue;
      u_here.push_back(u[k]), u_there.push_back(u[k + apart]);
      v_here.push_back(v[k]), v_there.push_back(v[k + apart]);
    }
    expect_independent(got.call, u_here, u_there, "the x of 3.3 in " + words, one_for_all);
    expect_independent(got.call, v_here, v_there, "the y of 3.3 in " + words, one_for_all);
    expect_independent(got.call, u_here, v_there, "x and y of 3.3 in " + words, one_for_all);
  };
  expect_pairs(1, "cells side by side are independent");
  expect_pairs(side, "cells one above the other are independent");
  expect_pairs(n, "one set and the next are independent");
}

const std::string cell_otherwise =
    "the variance within the cells is all that may be left: is each point uniform in its cell, x "
    "and y drawn independently?";

CHECK_CASE("3.3 the error falls as 1/N in the plane", "[3.3][points:2]") {
  Rng rng = check_rng();
  const auto expected = [](std::size_t side) {
    const auto axis = strata_of(gaussian, side);
    return expected_of(product_of(axis, axis));
  };
  const Tested g = product_over_axes("exp(-x^2-y^2)", gaussian);
  expect_level(jittered(rng, {8, 8}, 1000), g, expected(8),
               "estimates of exp(-x^2-y^2) over 8 x 8 cells have their exact variance",
               cell_otherwise);
  expect_slope(jittered(rng, {4, 4}, 500), jittered(rng, {16, 16}, 500), g,
               {expected(4), expected(16)}, "errors for exp(-x^2-y^2) fall as 1/N", cell_otherwise);
}

CHECK_CASE("3.3 the error falls as N^-3/4 across an edge", "[3.3][points:2]") {
  Rng rng = check_rng();
  const double edge = uniform(rng, 0.05, 0.15);
  const Tested g{fmt::format("1 where cos(1)(x-1/2) + sin(1)(y-1/2) < {:.6g}", edge), [=](View x) {
                   return std::cos(1.0) * (x[0] - 0.5) + std::sin(1.0) * (x[1] - 0.5) < edge ? 1.0
                                                                                             : 0.0;
                 }};
  const auto expected = [&](std::size_t side) {
    const auto cells = edge_strata(edge, side);
    return expected_of(cells, edge_kurtosis(cells));
  };
  // Jitter that a row of cells shares makes 1.2 times the variance here: 9000 sets see that always.
  const Sets at_8 = jittered(rng, {8, 8}, 9000);
  expect_level(at_8, g, expected(8),
               "estimates of an edge over 8 x 8 cells have their exact variance", cell_otherwise);
  expect_slope(
      jittered(rng, {8, 8}, 500), jittered(rng, {32, 32}, 500), g, {expected(8), expected(32)},
      "only the cells that the edge cuts have any variance: errors fall as N^-3/4", cell_otherwise);
}

CHECK_CASE("3.3 edges and waves and a corner have their exact variances", "[3.3][points:2]") {
  Rng rng = check_rng();
  constexpr std::size_t side = 8, n = side * side;
  const Sets got = jittered(rng, {side, side}, 4000);
  // An edge along the grid's own lines cuts no cell: every estimate is the exact one, a whole
  // number of rows over N.
  const std::size_t rows = 1 + rng() % (side - 1);
  const double line = static_cast<double>(rows) / side;
  for (const std::size_t axis : {0u, 1u}) {
    const Tested step{fmt::format("1 where {} < {}/{}", axis == 0 ? "x" : "y", rows, side),
                      [=](View x) { return x[axis] < line ? 1.0 : 0.0; }};
    const Values estimates = estimates_over(got, step, n);
    const auto odd = std::find_if(estimates.begin(), estimates.end(),
                                  [=](double estimate) { return estimate != line; });
    expect_that(odd == estimates.end(),
                odd == estimates.end()
                    ? ""
                    : fmt::format("{}: an estimate of {} is {}", got.call, step.words, *odd),
                fmt::format("{} from every set: no cell is cut, so there is no variance", line),
                "the edge lies on a line of the grid", "each cell has one point");
  }
  const Tested diagonal{"1 where y < x", [](View x) { return x[1] < x[0] ? 1.0 : 0.0; }};
  // The diagonal halves `side` cells, of variance 1/4 and kurtosis 1 each.
  const double halves = side * 0.25 / (n * n);
  expect_level(got, diagonal, {0.5, halves, 3 - 2.0 / side, 0.25 / n},
               "the diagonal cuts 8 of 64 cells in half", cell_otherwise);
  const Tested wave{"cos(2 pi nx x) cos(2 pi ny y)", [](View x) {
                      const double turns = 2 * std::numbers::pi * side;
                      return std::cos(turns * x[0]) * std::cos(turns * x[1]);
                    }};
  // Every cell has a whole period each way: mean 0, variance 1/4, kurtosis (3/8)^2 / (1/4)^2.
  expect_level(got, wave, {0, 0.25 / n, 3 - 0.75 / n},
               "all variance of a wave as fine as the cells is within them: nothing is gained",
               cell_otherwise);
  // Its errors have a longer tail than their kurtosis says: by their sixth moment a right answer
  // fails this one test about three times as often as alpha says.
  const Tested corner{"ln(x + y)", [](View x) { return std::log(x[0] + x[1]); }};
  const CornerStrata cells = corner_strata(side);
  expect_level(got, corner, expected_of(cells.strata, cells.kurtosis),
               "a corner where the integrand has no bound leaves the variance of its cells",
               cell_otherwise);
}

CHECK_CASE("3.3 no point leaves its cell whatever the bits", "[3.3][edge][points:1]") {
  Rng rng = check_rng();
  for (const Grid grid : {Grid{49, 98}, Grid{1 + rng() % 100, 1 + rng() % 100}, Grid{2, 3},
                          Grid{1009, 1}, Grid{1, 1009}, Grid{1, 1}}) {
    for (const std::uint64_t word : {~std::uint64_t{0}, std::uint64_t{0}, rng()}) {
      const Sets got = planes_of(MEASURE(stratified_2d_constant, grid, word), grid, 1);
      expect_one_in_each_cell(got.call, got.column(0, 0), got.column(0, 1), grid);
    }
  }
}

Call into_2d(std::uint64_t size_x, std::uint64_t size_y, Grid grid) {
  return MEASURE_OUTCOME(stratified_2d_into, size_x, size_y, grid);
}

CHECK_CASE("3.3 what is no grid of these points is refused", "[3.3][edge][points:1.5]") {
  expect_refused(wrong_grids(into_2d));
}

CHECK_CASE("3.3 the refusals name the argument", "[3.3][edge][points:0.5]") {
  expect_argument_named(wrong_grids(into_2d));
}

}  // namespace
}  // namespace mc::checks
