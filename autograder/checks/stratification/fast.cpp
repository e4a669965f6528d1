// 3.9: what fast code gets wrong: the rest after the last whole block, and streams that repeat.

#include "checks/stratification/common.hpp"
#include "checks/support/catch.hpp"

namespace mc::checks {
namespace {

const std::string rest = "the last block may be shorter than the others";

/// Numbers of cells on both sides of lengths that blocks may have.
constexpr std::size_t lengths[] = {4099, 1023, 1025, 63, 255, 257, 8191, 32769, 1000003};
constexpr Grid timed_grids[] = {{32, 32},   {1023, 3},   {3, 1025}, {4099, 1},
                                {257, 255}, {1000, 500}, {1, 1025}, {511, 9}};

Sets line_at(std::size_t n, std::size_t sets, Rng& rng) {
  return sets_from_columns(MEASURE(stratified_1d, n, sets, fresh_seed(rng)), n, 1, sets, n);
}
Sets plane_at(Grid grid, std::size_t sets, Rng& rng) {
  return sets_from_xy(MEASURE(stratified_2d, grid, sets, fresh_seed(rng)), grid, sets);
}

CHECK_CASE("3.9 blocks of any length have their strata",
           "[3.9][main][points:3][needs:3.1][needs:3.3]") {
  Rng rng = check_rng();
  for (const std::size_t n : lengths) {
    expect_one_in_each_cell(line_at(n, 1, rng), 0, line_of(n), rest);
  }
  for (const Grid grid : timed_grids) {
    expect_one_in_each_cell(plane_at(grid, 1, rng), 0, plane_of(grid), rest);
  }
  expect_fresh(line_at(4099, 2, rng), line_at(4099, 1, rng), {{line_of(4099)}});
}

CHECK_CASE("3.9 fast numbers are as independent as slow ones",
           "[3.9][edge][points:3][needs:3.1][needs:3.3]") {
  Rng rng = check_rng();
  // One long set has no replicates: positions are compared with each other. The size that is timed
  // is judged, too, with replicates: no answer knows a grid by its size.
  const std::vector<Pattern> line{line_of(32000)};
  expect_independent_uniforms(jitters_of(line_at(32000, 2, rng), line, rest),
                              random_jitters("3.1"));
  for (const auto& [grid, sets] : {std::pair<Grid, std::size_t>{{32, 32}, 100}, {{200, 160}, 1}}) {
    const std::vector<Pattern> plane{plane_of(grid)};
    expect_independent_uniforms(jitters_of(plane_at(grid, sets, rng), plane, rest),
                                random_jitters("3.3"));
  }
}

}  // namespace
}  // namespace mc::checks
