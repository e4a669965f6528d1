// 3.9: the irradiance from a light with strata. The variance within the strata is exact, by
// quadrature; for some lights and grids it is listed in the tests (exact_values_test.cpp).

#include "checks/stratification/common.hpp"
#include "checks/support/light_strata.hpp"

namespace mc::checks {
namespace {

RectLight random_light(Rng& rng) {
  return light_in({-1.5, 0.5}, {-1.5, 0.5}, {0.7, 2}, {0.7, 1.5}, rng);
}

ReplicatedEstimates estimates_of(const Measured<std::vector<Estimate>>& got, Grid grid,
                                 std::size_t replicates, std::size_t times) {
  return {got.call, got.exactly(times), grid.nx * grid.ny * replicates, replicates};
}

std::vector<Suspect> wrong_variances(const RectLight& light, Grid grid, const WithinStrata& cells);
std::vector<Suspect> wrong_values(const RectLight& light, double exact);

CHECK_CASE("3.9 the variance is that within the strata of the light",
           "[3.9][main][points:3][needs:3.3][needs:3.8]") {
  // A grid of the same number of cells has another variance for 8 x 2 or for 2 x 8.
  for (const Grid grid : {Grid{3, 2}, Grid{8, 2}, Grid{2, 8}}) {
    constexpr std::size_t replicates = 4, times = 2500;
    const RectLight light = random_light(rng);
    const WithinStrata cells = light_strata(light, grid);
    const auto got =
        MEASURE(irradiance_stratified, light, grid, replicates, times, fresh_seed(rng));
    expect_estimates(
        estimates_of(got, grid, replicates, times), irradiance(light), stratified_variance(cells),
        light_kurtosis(light, grid),
        {.suspects = wrong_variances(light, grid, cells),
         .rule = "each point is (x0 + (x1 - x0) u, y0 + (y1 - y0) v), with (u, v) from 3.3"},
        {.suspects = wrong_values(light, irradiance(light)),
         .rule = "the mean of area * radiance * cos * cos / distance^2, as in 2.7"});
  }
}

CHECK_CASE("3.9 the error bar is the spread of the replicates",
           "[3.9][points:2][needs:3.3][needs:3.8]") {
  for (const std::size_t replicates : {2u, 9u}) {
    constexpr std::size_t times = 1500;
    const Grid grid{4, 3};
    const RectLight light = random_light(rng);
    const WithinStrata cells = light_strata(light, grid);
    const auto got =
        MEASURE(irradiance_stratified, light, grid, replicates, times, fresh_seed(rng));
    const auto r = static_cast<double>(replicates);
    expect_bars(estimates_of(got, grid, replicates, times), stratified_variance(cells),
                light_kurtosis(light, grid),
                {.suspects = {{r,
                               "this is the standard deviation of one replicate: divide it by "
                               "sqrt(replicates)"_likely},
                              {independent_variance(cells, 12) / stratified_variance(cells),
                               "this is s / sqrt(n) over all points, as if they were identically "
                               "distributed: compute it from the replicates' means"_likely}},
                 .rule = "the error bar is that of 3.8, from the means of the replicates"});
  }
}

CHECK_CASE("3.9 one cell and one replicate", "[3.9][edge][points:0.5][needs:3.3][needs:3.8]") {
  for (const Grid grid : {Grid{5, 1}, Grid{1, 7}, Grid{1, 1}}) {
    const RectLight light = random_light(rng);
    const auto got = MEASURE(irradiance_stratified, light, grid, 3, 2000, fresh_seed(rng));
    expect_estimates(estimates_of(got, grid, 3, 2000), irradiance(light),
                     stratified_variance(light_strata(light, grid)), light_kurtosis(light, grid),
                     {{}, "any grid is valid, also a row, a column or a single cell"});
  }
  const auto one = MEASURE(irradiance_stratified, {}, {3, 2}, 1, 1, fresh_seed(rng));
  expect_nan(one.call + "[0].standard_error", one.list_by_list({{1, any_number}})[0].standard_error,
             "one mean has no spread, so the result is undefined");
}

// What the cases above use ------------------------------------------------------------------------

/// The ratios of variances that well-known mistakes give.
std::vector<Suspect> wrong_variances(const RectLight& light, Grid grid, const WithinStrata& cells) {
  const double right = stratified_variance(cells);
  const std::size_t n = grid.nx * grid.ny;
  return {
      {independent_variance(cells, n) / right,
       "this is the variance of independent points on the light: the map must keep strata"_likely},
      {(right + paired_anew_variance(cells, grid)) / right,
       "this is the variance of x and y paired anew: keep the x and the y of a "
       "point together"_likely},
      {stratified_variance(light_strata(light, squarest(n))) / right,
       "this is the variance of the most square grid with as many cells: use the given one"_likely},
      {stratified_variance(light_strata(light, {grid.ny, grid.nx})) / right,
       "this is the variance of a grid of ny x nx cells: nx counts the cells along x"_likely}};
}

/// The means of formulas that lack a factor.
std::vector<Suspect> wrong_values(const RectLight& light, double exact) {
  const double one_cosine =
      area(light) * light.radiance * mean_over(light, [h = light.height](double x, double y) {
        return h / std::pow(std::hypot(x, y, h), 3);
      });
  return {{exact / area(light),
           "the density of a point is 1 / area of the light: multiply by it"_likely},
          {one_cosine, "one of the two cosines is missing"_likely}};
}

}  // namespace
}  // namespace mc::checks
