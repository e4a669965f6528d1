// 3.9: what fast code gets wrong: the rest behind the last whole block, and streams that repeat.

#include <array>
#include <utility>

#include "checks/stratification/jitter.hpp"
#include "checks/support/catch.hpp"
#include "checks/support/strata.hpp"

namespace mc::checks {
namespace {

/// What is timed (speed.cpp) is judged: nobody knows a grid by its size.
constexpr Grid timed{32, 32};

/// Jitters of sets of one grid, set after set, each in the order of its cells.
struct Jitters {
  std::string call;
  Values x, y;
};
Jitters jitters_of_cells(Grid grid, std::size_t sets, std::uint64_t seed) {
  const std::size_t n = grid.nx * grid.ny;
  const Sets plane = planes_of(MEASURE(stratified_2d, grid, sets, seed), grid, sets);
  Jitters all{plane.call, Values(n * sets), Values(n * sets)};
  for (std::size_t set = 0; set < sets; ++set) {
    const View x = plane.column(set, 0), y = plane.column(set, 1);
    const auto cells = expect_one_in_each_cell(plane.call, x, y, grid);
    for (std::size_t k = 0; k < n; ++k) {
      all.x[set * n + cells[k]] = jitter_of(x[k], grid.nx);
      all.y[set * n + cells[k]] = jitter_of(y[k], grid.ny);
    }
  }
  return all;
}

CHECK_CASE("3.9 blocks of any length have their strata",
           "[3.9][main][points:3][needs:3.1][needs:3.3]") {
  Rng rng = check_rng();
  for (const std::size_t n : {4099u, 1023u, 1025u, 63u, 255u, 257u, 65537u, 1000000u}) {
    const Sets got = columns_of(MEASURE(stratified_1d, n, 1, fresh_seed(rng)), n, 1, 1, n);
    expect_in_order(got.call, got.column(0, 0));
  }
  for (const Grid grid :
       {timed, Grid{1023, 3}, Grid{3, 1025}, Grid{4099, 1}, Grid{257, 255}, Grid{1000, 500}}) {
    const Sets got = planes_of(MEASURE(stratified_2d, grid, 1, fresh_seed(rng)), grid, 1);
    expect_one_in_each_cell(got.call, got.column(0, 0), got.column(0, 1), grid);
  }
  constexpr std::size_t n = 4099;
  const auto line = [&](std::size_t sets) {
    return columns_of(MEASURE(stratified_1d, n, sets, fresh_seed(rng)), n, 1, sets, n);
  };
  expect_drawn_afresh(line(2), line(1), std::array{n});
}

/// z of the products of jitters u[k] and v[k + lag] about 1/2, for lags first, first + 1, …:
/// standard normal for independent ones, whose products have variance 1/144.
Values lag_correlations(const Values& u, const Values& v, std::size_t first, std::size_t lags) {
  Values z;
  for (std::size_t lag = first; lag < first + lags; ++lag) {
    double sum = 0;
    for (std::size_t k = 0; k + lag < u.size(); ++k) sum += (u[k] - 0.5) * (v[k + lag] - 0.5);
    z.push_back(12 * sum / std::sqrt(static_cast<double>(u.size() - lag)));
  }
  return z;
}

CHECK_CASE("3.9 fast numbers are as independent as slow ones",
           "[3.9][edge][points:3][needs:3.1][needs:3.3]") {
  Rng rng = check_rng();
  constexpr std::size_t n = 32000, lags = 40;
  const std::string streams =
      "points some strata apart move alike, as where each block begins with the same numbers, or "
      "streams that run side by side are copies of each other";
  const Sets line = columns_of(MEASURE(stratified_1d, n, 2, fresh_seed(rng)), n, 1, 2, n);
  const Values u = jitters_of(line, 0, n);
  const double each = 1.0 / 32;
  expect_counts(line.call + ", places of points within their strata, in 32 equal parts",
                counts_of(u, 32), std::span(&each, 1),
                {"long patterns of 3.1 are uniform in their strata", alpha}, {{}, jitter_hint(u)});
  expect_variance(
      {line.call + ", correlations of strata 1 to 40 apart", lag_correlations(u, u, 1, lags)}, 0, 1,
      3, {"strata of 3.1 near each other are independent", alpha}, {{}, streams});
  for (const auto& [grid, sets] : {std::pair{Grid{200, 160}, 1}, std::pair{timed, 31}}) {
    const auto [call, x, y] =
        jitters_of_cells(grid, static_cast<std::size_t>(sets), fresh_seed(rng));
    expect_independent(call, x, y, "long patterns of 3.3 are uniform in their cells",
                       "the same random number moves x and y");
    Values z = lag_correlations(x, x, 1, lags);
    for (const Values& more : {lag_correlations(y, y, 1, lags), lag_correlations(x, y, 1, lags)}) {
      z.insert(z.end(), more.begin(), more.end());
    }
    expect_variance({call + ", correlations of cells up to 40 apart", z}, 0, 1, 3,
                    {"cells of 3.3 near each other are independent", alpha}, {{}, streams});
  }
}

}  // namespace
}  // namespace mc::checks
