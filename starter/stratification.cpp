// Lab 3 · stratification. What each function promises stands in
// labs/3-stratification/stratification.hpp; the story is in labs/3-stratification/README.md. Write
// the tasks in any order and try them with
//
//   ./lab check stratification              all of it
//   ./lab check stratification --only 3.1   one task

#include "stratification.hpp"

#include "common/todo.hpp"

namespace mc {

void stratified_1d(std::span<double> /*x*/, Rng& /*rng*/) {
  throw todo("3.1");  // TODO(3.1): one point in each stratum, in order; mind the upper edge
}

Grid strata(std::size_t /*n*/) {
  throw todo("3.2");  // TODO(3.2): the two factors of n that are closest to each other
}

void stratified_2d(std::span<double> /*x*/, std::span<double> /*y*/, Grid /*grid*/, Rng& /*rng*/) {
  throw todo("3.3");  // TODO(3.3): one point in each cell; check the sizes first
}

void shuffle(std::span<double> /*x*/, Rng& /*rng*/) {
  throw todo("3.4");  // TODO(3.4): swap each value with one of those not placed yet, or itself
}

void stratified(PointSet& /*points*/, Rng& /*rng*/) {
  throw todo("3.4");  // TODO(3.4): a 2D pattern for each pair of dimensions, in an order of its own
}

void stratified_nd(PointSet& /*points*/, std::size_t /*per_axis*/, Rng& /*rng*/) {
  throw todo("3.5");  // TODO(3.5): point k in cell k, whose number is d digits in base per_axis
}

void latin_hypercube(PointSet& /*points*/, Rng& /*rng*/) {
  throw todo("3.6");  // TODO(3.6): every axis stratified, in an order of its own
}

void multi_jittered(std::span<double> /*x*/, std::span<double> /*y*/, Grid /*grid*/, Rng& /*rng*/) {
  throw todo("3.7");  // TODO(3.7): which of the ny strata within its cell's column does x take?
}

Estimate estimate_replicated(const Integrand& /*g*/, const Generator& /*generator*/,
                             std::uint64_t /*n*/, std::uint64_t /*replicates*/, Rng& /*rng*/) {
  throw todo("3.8");  // TODO(3.8): a mean of means, and the standard error of those
}

// TODO(3.9): the speed task. It has no function of its own: come back to 3.1 and 3.3 when they are
// right, and make them cost no more than the random numbers that they use.

}  // namespace mc
