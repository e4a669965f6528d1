#pragma once
// Lab 3's ways of making points, as the bench and the speed tasks take them.

#include <cmath>

#include "3-stratification/experiments.hpp"
#include "measurements/support/bench_data.hpp"

namespace mc::checks {

/// The whole number nearest to the d-th root of n.
inline std::uint64_t root(std::uint64_t n, std::uint64_t d) {
  return static_cast<std::uint64_t>(
      std::llround(std::pow(static_cast<double>(n), 1 / static_cast<double>(d))));
}

/// Of an experiment that gives sets column by column.
template <class Measured>
std::optional<PointSets> column_sets(std::uint64_t n, std::uint64_t dims, std::uint64_t sets,
                                     const Measured& measured) {
  if (!measured) return {};
  const auto* values = measured->if_exactly(n * dims * sets, unit);
  if (values == nullptr) return {};
  return PointSets{n, dims, *values};
}

/// Of one that gives all x and all y.
template <class Measured>
std::optional<PointSets> plane_sets(std::uint64_t n, std::uint64_t sets, const Measured& measured) {
  if (!measured) return {};
  const auto* points = measured->if_exactly(n * sets, unit);
  if (points == nullptr) return {};
  PointSets all{n, 2, {}};
  for (std::size_t first = 0; first < n * sets; first += n) {
    for (const auto* column : {&points->x, &points->y}) {
      const auto from = column->begin() + static_cast<std::ptrdiff_t>(first);
      all.values.insert(all.values.end(), from, from + static_cast<std::ptrdiff_t>(n));
    }
  }
  return all;
}

/// `sets` sets of n points of task 3.`task`.
inline std::optional<PointSets> points_of(unsigned task, std::uint64_t n, std::uint64_t dims,
                                          std::uint64_t sets, std::uint64_t seed) {
  const Grid grid{root(n, 2), root(n, 2)};
  switch (task) {
    case 1:
      return column_sets(n, 1, sets, TRY_MEASURE(stratified_1d, n, sets, seed));
    case 3:
      return plane_sets(n, sets, TRY_MEASURE(stratified_2d, grid, sets, seed));
    case 4:
      return column_sets(n, dims, sets, TRY_MEASURE(stratified, n, dims, sets, seed));
    case 5:
      return column_sets(n, dims, sets,
                         TRY_MEASURE(stratified_nd, n, dims, root(n, dims), sets, seed));
    case 6:
      return column_sets(n, dims, sets, TRY_MEASURE(latin_hypercube, n, dims, sets, seed));
    default:
      return plane_sets(n, sets, TRY_MEASURE(multi_jittered, grid, sets, seed));
  }
}

/// CPU time of making the points of task 3.`task`.
inline std::optional<double> seconds_of_points(unsigned task, std::uint64_t n, std::uint64_t dims,
                                               std::uint64_t rounds) {
  return cpu_seconds_of(TRY_MEASURE(repeat, task, n, dims, rounds, 1));
}

inline BenchSampler sampler(unsigned task, std::string name, std::vector<std::uint64_t> dims) {
  BenchSampler made;
  made.name = std::move(name);
  made.dims = std::move(dims);
  made.power_of_root = task == 5;
  made.points = [=](std::uint64_t n, std::uint64_t d, std::uint64_t sets, std::uint64_t seed) {
    return points_of(task, n, d, sets, seed);
  };
  made.rounds = [=](std::uint64_t n, std::uint64_t d, std::uint64_t rounds) {
    return seconds_of_points(task, n, d, rounds);
  };
  return made;
}

}  // namespace mc::checks
