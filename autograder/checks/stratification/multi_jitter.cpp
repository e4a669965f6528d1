// 3.7: multi-jittered points.

#include "checks/stratification/common.hpp"

namespace mc::checks {
namespace {

Stratified multi_jittered(Grid grid) {
  const std::size_t n = grid.nx * grid.ny;
  return {"3.7",
          [=](std::size_t sets, std::uint64_t seed) {
            return sets_from_xy(MEASURE(multi_jittered, grid, sets, seed), grid, sets);
          },
          {plane_of(grid), line_of(n, 0), line_of(n, 1)},
          "each column of cells has ny strata of x, each row nx strata of y"};
}

/// The same, as points in the strata of the axes, or in the cells.
Stratified in_strata(Grid grid) {
  Stratified made = multi_jittered(grid);
  made.patterns.erase(made.patterns.begin());
  return made;
}
Stratified in_cells(Grid grid) {
  Stratified made = multi_jittered(grid);
  made.patterns.resize(1);
  return made;
}

void expect_strata(const std::vector<Grid>& grids, Rng& rng) {
  for (const Grid grid : grids) multi_jittered(grid).expect_cells(2, rng);
}

CHECK_CASE("3.7 strata of the plane and of both axes at once", "[3.7][main][points:4]") {
  expect_strata({{8, 8}, {16, 4}, {3, 5}, {5 + rng() % 30, 5 + rng() % 30}}, rng);
  in_strata({8, 8}).expect_new_points(rng);
}

CHECK_CASE("3.7 any grid", "[3.7][edge][points:1]") {
  expect_strata({{33, 31},
                 {1, 1025},
                 {4097, 1},
                 {257, 129},
                 {65539, 1},
                 {701, 499},
                 {7, 1},
                 {1, 11},
                 {2, 2},
                 {1, 3},
                 {3, 1},
                 {1, 2},
                 {2, 1},
                 {1, 1}},
                rng);
}

CHECK_CASE("3.7 each point is uniform in its strata of x and y", "[3.7][points:1]") {
  for (const Grid grid : {Grid{4, 3}, Grid{1, 4}, Grid{32, 31}}) {
    const std::size_t sets = std::max<std::size_t>(100, 24000 / (grid.nx * grid.ny));
    expect_random_calls(in_strata(grid).jitters(), sets, rng);
  }
}

std::string hint_of_arrangement(const Uniforms& jitters, Grid grid);

CHECK_CASE("3.7 each point is uniform in its cell", "[3.7][points:4][needs:3.4]") {
  for (const Grid grid : {Grid{4, 3}, Grid{3, 3}, Grid{2, 2}, Grid{1, 5}, Grid{33, 2}, Grid{2, 35},
                          Grid{2, 601}, Grid{599, 2}}) {
    const std::size_t n = grid.nx * grid.ny, sets = std::min<std::size_t>(8000, 600'000 / n);
    const Uniforms places = in_cells(grid).jitters().numbers(fresh_seed(rng), sets);
    const Randomness claim{
        .words =
            fmt::format("a point of {} x {} cells lies anywhere in its cell", grid.nx, grid.ny),
        .alpha = alpha,
        .rule = hint_of_arrangement(places, grid),
        .expected = "a uniform point of the cell"};
    // Points may share permutations: cells are judged separately; if many, so are coordinates.
    const std::size_t judged = n <= 12 ? std::min<std::size_t>(n, 9) : 5;
    for (std::size_t k = 0; k < judged; ++k) {
      const std::size_t cell = (k * n + rng() % n) / judged;
      const std::vector<std::vector<std::size_t>> together{{cell, n + cell}},
          apart{{cell}, {n + cell}};
      for (const std::vector<std::size_t>& at : n <= 12 ? together : apart) {
        expect_independent_uniforms(some_of(places, at), claim);
      }
    }
  }
}

CHECK_CASE("3.7 a sum is estimated as in one dimension", "[3.7][points:1]") {
  Level sum = level_of("exp(x) + exp(y)", sum_over_axes(exponential), strata_of(exponential, 64));
  sum.mean *= 2, sum.variance *= 2, sum.independent *= 2;  // two independent terms
  expect_level(multi_jittered({8, 8}).some(1000, rng), sum);
}

// What the cases above use ------------------------------------------------------------------------

/// Whether the x, and the y, of all points lie in the strata of the canonical arrangement.
std::string hint_of_arrangement(const Uniforms& jitters, Grid grid) {
  std::array<bool, 2> stay{true, true};
  for (std::size_t i = 0; i < jitters.values.size(); ++i) {
    const std::size_t n = grid.nx * grid.ny, cell = i % n, axis = i / n % 2;
    const auto parts = static_cast<double>(axis == 0 ? grid.ny : grid.nx);
    const auto part = static_cast<std::size_t>(jitters.values[i] * parts);
    stay[axis] = stay[axis] && part == (axis == 0 ? cell / grid.nx : cell % grid.nx);
  }
  const std::string assign =
      "random permutations, all equally likely, must assign the strata of x to the cells of each "
      "column, and, independent of these, the strata of y to the cells of each row";
  if (stay[0] && stay[1]) return "this is the canonical arrangement, which is biased: " + assign;
  return (stay[1] ? "x is shuffled and y is not: " : "") + assign;
}

}  // namespace
}  // namespace mc::checks
