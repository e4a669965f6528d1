// Mistakes in task 3.9.
#include "stratification.hpp"

#define irradiance_stratified right_irradiance_stratified
#include "solutions/stratification.cpp"
#undef irradiance_stratified

namespace mc {
namespace {

void require_strata(Grid grid) {
  if (grid.nx == 0 || grid.ny == 0) throw std::invalid_argument("grid: nx and ny must be positive");
}

/// The value at (u, v), with the cosines to a power: 2 is right.
double value_at(const RectLight& light, double u, double v, double cosines = 2) {
  const double width = light.x1 - light.x0, depth = light.y1 - light.y0;
  const double x = light.x0 + width * u, y = light.y0 + depth * v;
  const double distance2 = x * x + y * y + light.height * light.height;
  const double cosine = light.height / std::sqrt(distance2);
  return width * depth * light.radiance * std::pow(cosine, cosines) / distance2;
}

/// The estimate of `value` over jittered grids that `change` has changed.
template <class Value, class Change>
Estimate over_grids(Grid grid, std::uint64_t replicates, Rng& rng, Value value, Change change) {
  require_strata(grid);
  const auto jittered = [&](PointSet& points, Rng& from) {
    stratified_2d(points.column(0), points.column(1), grid, from);
    change(points, from);
  };
  return estimate_replicated({2, value}, jittered, grid.nx * grid.ny, replicates, rng);
}

template <class Change>
Estimate over_changed(const RectLight& light, Grid grid, std::uint64_t replicates, Rng& rng,
                      Change change) {
  const auto value = [&](std::span<const double> u) { return value_at(light, u[0], u[1]); };
  return over_grids(grid, replicates, rng, value, change);
}

}  // namespace
}  // namespace mc

// mistake: shuffles the y of a grid's points apart from the x
// hint: this is the variance of x and y paired anew
namespace mc::pairs_coordinates_anew {
Estimate irradiance_stratified(const RectLight& light, Grid grid, std::uint64_t replicates,
                               Rng& rng) {
  return over_changed(light, grid, replicates, rng,
                      [](PointSet& points, Rng& from) { shuffle(points.column(1), from); });
}
}  // namespace mc::pairs_coordinates_anew

// mistake: maps each cell to the whole light: uniform points, but without strata
// hint: this is the variance of independent points on the light
namespace mc::map_breaks_strata {
Estimate irradiance_stratified(const RectLight& light, Grid grid, std::uint64_t replicates,
                               Rng& rng) {
  return over_changed(light, grid, replicates, rng, [&](PointSet& points, Rng&) {
    for (double& u : points.column(0))
      u = u * static_cast<double>(grid.nx) - std::floor(u * static_cast<double>(grid.nx));
    for (double& v : points.column(1))
      v = v * static_cast<double>(grid.ny) - std::floor(v * static_cast<double>(grid.ny));
  });
}
}  // namespace mc::map_breaks_strata

// mistake: uses u along y and v along x
// hint: this is the variance of a grid of ny x nx cells
namespace mc::turns_the_grid {
Estimate irradiance_stratified(const RectLight& light, Grid grid, std::uint64_t replicates,
                               Rng& rng) {
  return over_changed(light, grid, replicates, rng, [](PointSet& points, Rng&) {
    std::swap_ranges(points.column(0).begin(), points.column(0).end(), points.column(1).begin());
  });
}
}  // namespace mc::turns_the_grid

// mistake: forgets to divide by the density, 1 / area
// hint: the density of a point is 1 / area of the light
namespace mc::forgets_the_density {
Estimate irradiance_stratified(const RectLight& light, Grid grid, std::uint64_t replicates,
                               Rng& rng) {
  Estimate estimate = right_irradiance_stratified(light, grid, replicates, rng);
  const double area = (light.x1 - light.x0) * (light.y1 - light.y0);
  estimate.value /= area;
  estimate.standard_error /= area;
  return estimate;
}
}  // namespace mc::forgets_the_density

// mistake: forgets the cosine at the light
// hint: one of the two cosines is missing
namespace mc::one_cosine {
Estimate irradiance_stratified(const RectLight& light, Grid grid, std::uint64_t replicates,
                               Rng& rng) {
  const auto value = [&](std::span<const double> u) { return value_at(light, u[0], u[1], 1); };
  return over_grids(grid, replicates, rng, value, [](PointSet&, Rng&) {});
}
}  // namespace mc::one_cosine

// mistake: returns the standard deviation of one replicate as the error of the mean
// hint: this is the standard deviation of one replicate
namespace mc::bar_of_one_light {
Estimate irradiance_stratified(const RectLight& light, Grid grid, std::uint64_t replicates,
                               Rng& rng) {
  Estimate estimate = right_irradiance_stratified(light, grid, replicates, rng);
  estimate.standard_error *= std::sqrt(static_cast<double>(replicates));
  return estimate;
}
}  // namespace mc::bar_of_one_light

// mistake: returns s / sqrt(n) over all points, as if they were identically distributed
// hint: as if they were identically distributed
namespace mc::bar_of_all_points {
Estimate irradiance_stratified(const RectLight& light, Grid grid, std::uint64_t replicates,
                               Rng& rng) {
  Moments all;
  const auto value = [&](std::span<const double> u) {
    const double one = value_at(light, u[0], u[1]);
    add(all, one);
    return one;
  };
  Estimate estimate = over_grids(grid, replicates, rng, value, [](PointSet&, Rng&) {});
  if (replicates > 1) {
    estimate.standard_error = std::sqrt(variance(all) / static_cast<double>(all.count));
  }
  return estimate;
}
}  // namespace mc::bar_of_all_points

// mistake: counts one replicate in Estimate::n
// hint: those of all replicates
namespace mc::counts_one_replicate {
Estimate irradiance_stratified(const RectLight& light, Grid grid, std::uint64_t replicates,
                               Rng& rng) {
  Estimate estimate = right_irradiance_stratified(light, grid, replicates, rng);
  estimate.n /= replicates;
  return estimate;
}
}  // namespace mc::counts_one_replicate

// mistake: draws from a copy of the generator, so the next estimate has the same points
// hint: draw from the generator that is passed in, not from a copy
namespace mc::light_from_a_copy {
Estimate irradiance_stratified(const RectLight& light, Grid grid, std::uint64_t replicates,
                               Rng& rng) {
  Rng copy = rng;
  return right_irradiance_stratified(light, grid, replicates, copy);
}
}  // namespace mc::light_from_a_copy

// mistake: takes the most square grid with as many cells instead of the given one
// hint: this is the variance of the most square grid
namespace mc::squarest_grid {
Estimate irradiance_stratified(const RectLight& light, Grid grid, std::uint64_t replicates,
                               Rng& rng) {
  require_strata(grid);
  return right_irradiance_stratified(light, strata(grid.nx * grid.ny), replicates, rng);
}
}  // namespace mc::squarest_grid
