// Lab 3 · stratification. labs/3-stratification/stratification.hpp states what each function
// promises, and labs/3-stratification/README.md is the handout. Write the tasks in any order and
// check them with
//
//   ./lab check stratification              the whole lab
//   ./lab check stratification --only 3.1   one task

#include "stratification.hpp"

#include <stdexcept>

#include "common/todo.hpp"

namespace mc {

/// A finished example: the number of points in [x.low, x.high) x [y.low, y.high).
[[maybe_unused]] static std::size_t count_in_box(const PointSet& points, Interval x, Interval y) {
  if (points.dims() < 2) throw std::invalid_argument("points: must have at least two dimensions");
  std::size_t count = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double px = points.column(0)[i];
    const double py = points.column(1)[i];
    if (px >= x.low && px < x.high && py >= y.low && py < y.high) ++count;
  }
  return count;
}

void stratified_1d(std::span<double> x, Rng& rng) {
  throw todo("3.1");  // TODO(3.1): (i + u) / N, in order; rounding must not reach the upper edge
}

Grid strata(std::size_t n) {
  throw todo("3.2");  // TODO(3.2): the two factors of n that are closest to each other
}

void stratified_2d(std::span<double> x, std::span<double> y, Grid grid, Rng& rng) {
  throw todo("3.3");  // TODO(3.3): one point in each cell; check the sizes first
}

void shuffle(std::span<double> x, Rng& rng) {
  throw todo("3.4");  // TODO(3.4): swap each value with itself or with one not yet placed
}

void stratified(PointSet& points, Rng& rng) {
  throw todo("3.4");  // TODO(3.4): a jittered grid per pair of dimensions, shuffled
}

void stratified_nd(PointSet& points, std::size_t per_axis, Rng& rng) {
  throw todo("3.5");  // TODO(3.5): the strata of cell k are the digits of k in base per_axis
}

void latin_hypercube(PointSet& points, Rng& rng) {
  throw todo("3.6");  // TODO(3.6): stratify every axis, and shuffle each independently
}

void multi_jittered(std::span<double> x, std::span<double> y, Grid grid, Rng& rng) {
  throw todo("3.7");  // TODO(3.7): one point in each cell, in each stratum of x and of y
}

Estimate estimate_replicated(const Integrand& g, const Generator& generator, std::uint64_t n,
                             std::uint64_t replicates, Rng& rng) {
  throw todo("3.8");  // TODO(3.8): the mean of the replicates' means, and its standard error
}

Estimate irradiance_stratified(const RectLight& light, Grid grid, std::uint64_t replicates,
                               Rng& rng) {
  throw todo("3.9");  // TODO(3.9): a jittered grid on the light, and the error bar of 3.8
}

// TODO(3.10): stretch, no function: when 3.1 and 3.3 are correct, make them cost no more than the
// random numbers that they use.

}  // namespace mc
