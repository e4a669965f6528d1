// Mistakes in task 3.5.
#include "stratification.hpp"

#include <cmath>

#define stratified_nd right_stratified_nd
#include "solutions/stratification.cpp"
#undef stratified_nd

// mistake: moves a point along all axes of its cell by one random number
// hint: the jitter of coordinate 0 in cell 0 and the jitter of coordinate 1 in cell 0 share
namespace mc::along_the_cells_diagonal {
void stratified_nd(PointSet& points, std::size_t per_axis, Rng& rng) {
  right_stratified_nd(points, per_axis, rng);
  const Strata strata(per_axis);
  for (std::size_t k = 0; k < points.size(); ++k) {
    const double u = to_unit(rng());
    for (std::size_t d = 0; d < points.dims(); ++d) {
      double& x = points.column(d)[k];
      x = strata.place(std::floor(x * static_cast<double>(per_axis)), u);
    }
  }
}
}  // namespace mc::along_the_cells_diagonal

// mistake: stratifies every axis separately and calls that a grid
// hint: strata are the digits of k in base per_axis
namespace mc::every_axis_by_itself {
void stratified_nd(PointSet& points, std::size_t per_axis, Rng& rng) {
  right_stratified_nd(points, per_axis, rng);  // throws what is to be thrown
  latin_hypercube(points, rng);
}
}  // namespace mc::every_axis_by_itself

// mistake: jitters with 24 random bits in all dimensions
// hint: the random numbers have too few bits
namespace mc::float_jitter_in_all_axes {
void stratified_nd(PointSet& points, std::size_t per_axis, Rng& rng) {
  right_stratified_nd(points, per_axis, rng);
  const Strata strata(per_axis);
  for (std::size_t d = 0; d < points.dims(); ++d) {
    for (double& x : points.column(d)) {
      const auto jitter = static_cast<float>(rng() >> 40) * 0x1p-24f;
      x = strata.place(std::floor(x * static_cast<double>(per_axis)), jitter);
    }
  }
}
}  // namespace mc::float_jitter_in_all_axes

// mistake: jitters x once per layer of cells, and every other axis likewise
// hint: share one random number: draw one for every coordinate
namespace mc::jitter_by_layers {
void stratified_nd(PointSet& points, std::size_t per_axis, Rng& rng) {
  right_stratified_nd(points, per_axis, rng);
  std::vector<double> layers(per_axis);
  for (std::size_t d = 0; d < points.dims(); ++d) {
    stratified_1d(layers, rng);
    for (double& x : points.column(d)) {
      x = layers[static_cast<std::size_t>(x * static_cast<double>(per_axis))];
    }
  }
}
}  // namespace mc::jitter_by_layers

// mistake: compares per_axis^dims with N in 64 bits, which wrap around
// hint: wraps around: divide first
namespace mc::power_overflows {
void stratified_nd(PointSet& points, std::size_t per_axis, Rng& rng) {
  std::size_t cells = 1;
  for (std::size_t d = 0; d < points.dims(); ++d) cells *= per_axis;
  if (per_axis == 0 || cells != points.size()) {
    throw std::invalid_argument("per_axis: per_axis^dims is not the number of points");
  }
  if (per_axis <= points.size()) return right_stratified_nd(points, per_axis, rng);
  latin_hypercube(points, rng);
}
}  // namespace mc::power_overflows

// mistake: jitters by the mean of two random numbers
// hint: too many numbers lie near 1/2
namespace mc::jitter_of_two_numbers {
void stratified_nd(PointSet& points, std::size_t per_axis, Rng& rng) {
  right_stratified_nd(points, per_axis, rng);
  const Strata strata(per_axis);
  for (std::size_t d = 0; d < points.dims(); ++d) {
    for (double& x : points.column(d)) {
      const double u = (to_unit(rng()) + to_unit(rng())) / 2;
      x = strata.place(std::floor(x * static_cast<double>(per_axis)), u);
    }
  }
}
}  // namespace mc::jitter_of_two_numbers
