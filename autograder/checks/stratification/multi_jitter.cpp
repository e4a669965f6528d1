// 3.7: strata of the plane and of both axes at once.

#include "checks/stratification/levels.hpp"
#include "checks/support/catch.hpp"
#include "checks/support/inversions.hpp"

namespace mc::checks {
namespace {

const std::string fine_strata =
    "a column of cells has ny strata of x, one for each of its cells; a row nx of y";

Sets multi_jittered(Grid grid, std::size_t sets, Rng& rng) {
  return sets_from_xy(MEASURE(multi_jittered, grid, sets, fresh_seed(rng)), grid, sets);
}

CHECK_CASE("3.7 strata of the plane and of both axes at once", "[3.7][main][points:5]") {
  Rng rng = check_rng();
  for (const Grid grid : {Grid{8, 8}, Grid{16, 4}, Grid{3, 5}, Grid{2 + rng() % 30, 2 + rng() % 30},
                          Grid{33, 31}, Grid{1, 1025}, Grid{4097, 1}, Grid{257, 129}, Grid{7, 1},
                          Grid{1, 11}, Grid{2, 2}, Grid{1, 2}, Grid{2, 1}, Grid{1, 1}}) {
    const std::size_t n = grid.nx * grid.ny;
    const Sets got = multi_jittered(grid, 2, rng);
    for (std::size_t set = 0; set < 2; ++set) {
      for (const Pattern& pattern : {plane_of(grid), line_of(n, 0), line_of(n, 1)}) {
        expect_one_in_each_cell(got, set, pattern, fine_strata);
      }
    }
  }
  expect_fresh(multi_jittered({8, 8}, 2, rng), multi_jittered({8, 8}, 1, rng),
               {{line_of(64, 0), line_of(64, 1)}});
}

/// Which of the ny strata of x, and of the nx strata of y, of its cell each point lies in.
struct Parts {
  Uniforms numbers;                     ///< cell by cell: x, then y
  bool x_stays = true, y_stays = true;  ///< where the canonical arrangement is
};
Parts parts_of(const Sets& sets, Grid grid, Rng& rng) {
  Parts parts{{sets.call, 2 * sets.n}};
  parts.numbers.values.resize(sets.size() * 2 * sets.n);
  for (std::size_t set = 0; set < sets.size(); ++set) {
    const auto cells = expect_one_in_each_cell(sets, set, plane_of(grid), fine_strata);
    for (std::size_t k = 0; k < sets.n; ++k) {
      const auto part = [&](std::size_t d, std::size_t across, std::size_t along) {
        const double jitter = jitter_of(sets.column(set, d)[k], across);
        return static_cast<std::size_t>(jitter * static_cast<double>(along));
      };
      const std::size_t x = part(0, grid.nx, grid.ny), y = part(1, grid.ny, grid.nx);
      const std::size_t at = (set * sets.n + cells[k]) * 2;
      parts.numbers.values[at] = fill_cell(x, grid.ny, rng);
      parts.numbers.values[at + 1] = fill_cell(y, grid.nx, rng);
      parts.x_stays = parts.x_stays && x == cells[k] / grid.nx;
      parts.y_stays = parts.y_stays && y == cells[k] % grid.nx;
    }
  }
  parts.numbers.name = [nx = grid.nx](std::size_t position) {
    const std::size_t cell = position / 2;
    return fmt::format("the place of {} within cell ({}, {})", position % 2 == 0 ? "x" : "y",
                       cell % nx, cell / nx);
  };
  return parts;
}

/// One cell of all sets.
Uniforms of_cell(const Uniforms& all, std::size_t cell) {
  Uniforms one{all.call, 2};
  for (std::size_t set = 0; set < all.replicates(); ++set) {
    for (const std::size_t at : {2 * cell, 2 * cell + 1}) {
      one.values.push_back(all.values[set * all.positions + at]);
    }
  }
  one.name = [name = all.name, cell](std::size_t position) { return name(2 * cell + position); };
  return one;
}

CHECK_CASE("3.7 each point is uniform in its cell", "[3.7][points:4][needs:3.4]") {
  Rng rng = check_rng();
  for (const Grid grid : {Grid{4, 3}, Grid{3, 3}, Grid{2, 2}, Grid{1, 5}, Grid{16, 9}}) {
    const std::size_t n = grid.nx * grid.ny, sets = n > 100 ? 1000 : 8000;
    const auto [numbers, x_stays, y_stays] = parts_of(multi_jittered(grid, sets, rng), grid, rng);
    const Randomness claim{
        .words =
            fmt::format("a point of {} x {} cells lies anywhere in its cell", grid.nx, grid.ny),
        .alpha = alpha,
        .otherwise =
            x_stays && y_stays
                ? "this is the canonical arrangement, which is biased: permute at random which "
                  "cell of a column takes which stratum of x, and which cell of a row takes which "
                  "stratum of y"
            : y_stays ? "x is shuffled and y is not: permute at random which cell of a row takes "
                        "which stratum of y"
            : x_stays ? "y is shuffled and x is not: permute at random which cell of a column "
                        "takes which stratum of x"
                      : "random permutations, all of them equally likely, give the strata of x to "
                        "the cells of each column, and the strata of y to the cells of each row"};
    // Points of a set may share permutations: each cell is judged by itself.
    for (std::size_t k = 0; k < std::min<std::size_t>(n, 9); ++k) {
      auto failure = dependence_in(of_cell(numbers, n <= 9 ? k : rng() % n), claim);
      if (!failure) continue;
      failure->expected = "any of the places, all equally likely";
      failure->likely = claim.otherwise;
      fail(*failure);
    }
  }
  pass();
}

CHECK_CASE("3.7 each point is uniform in its strata of x and y", "[3.7][points:1]") {
  Rng rng = check_rng();
  for (const Grid grid : {Grid{4, 3}, Grid{1, 4}, Grid{32, 31}}) {
    const std::size_t n = grid.nx * grid.ny;
    const std::vector<Pattern> axes{line_of(n, 0), line_of(n, 1)};
    const Sets got = multi_jittered(grid, std::max<std::size_t>(100, 24000 / n), rng);
    expect_independent_uniforms(jitters_of(got, axes, fine_strata), random_jitters("3.7"));
  }
}

CHECK_CASE("3.7 a sum is estimated as in one dimension", "[3.7][points:1]") {
  Rng rng = check_rng();
  Level sum = level_of("exp(x) + exp(y)", sum_over_axes(exponential), strata_of(exponential, 64));
  sum.mean *= 2, sum.variance *= 2, sum.independent *= 2;  // one x in each of 64 strata, and one y
  expect_level(multi_jittered({8, 8}, 1000, rng), sum);
}

Call into_multi(std::uint64_t size_x, std::uint64_t size_y, Grid grid) {
  return MEASURE_OUTCOME(multi_jittered_into, size_x, size_y, grid);
}

REFUSAL_CASES("3.7", "what is no grid of these points is refused", "0.5",
              "the refusals name the argument", "0.5", wrong_grids(into_multi))

}  // namespace
}  // namespace mc::checks
