#pragma once
// The points of lab 5 whose error and speed are shown: by the bench, and beside a verdict.

#include <algorithm>
#include <numeric>
#include <utility>

#include "5-halton/experiments.hpp"
#include "checks/support/data.hpp"
#include "measurements/halton/measured_columns.hpp"
#include "measurements/support/bench_data.hpp"

namespace mc::checks {

/// Deterministic points have an error, but no RMSE: they are shifted by `sets` random vectors,
/// here, so that it is done alike for all.
inline std::optional<PointSets> shifted_sets(const Column& points, std::uint64_t n,
                                             std::uint64_t dims, std::uint64_t sets,
                                             std::uint64_t seed) {
  if (!points) return {};
  Rng rng(seed);
  PointSets all{n, dims, {}};
  all.values.reserve(n * dims * sets);
  for (std::uint64_t column = 0; column < sets * dims; ++column) {
    const double shift = uniform(rng);
    for (std::uint64_t i = 0; i < n; ++i) {
      const double moved = (*points)[column % dims * n + i] + shift;
      all.values.push_back(moved < 1 ? moved : moved - 1);
    }
  }
  return all;
}

/// `scrambled(d, seeds)` makes column d by each seed, one after the other: sets of those.
template <class Scramble>
std::optional<PointSets> scrambled_sets(std::uint64_t n, std::uint64_t dims, std::uint64_t sets,
                                        std::uint64_t seed, Scramble scrambled) {
  PointSets all{n, dims, std::vector<double>(n * dims * sets)};
  for (std::uint64_t d = 0; d < dims; ++d) {
    std::vector<std::uint64_t> seeds(sets);
    std::iota(seeds.begin(), seeds.end(), (seed * 64 + d) << 20);
    const Column columns = scrambled(static_cast<unsigned>(d), seeds);
    if (!columns) return {};
    for (std::uint64_t set = 0; set < sets; ++set) {
      std::copy_n(columns->begin() + static_cast<std::ptrdiff_t>(set * n), n,
                  all.values.begin() + static_cast<std::ptrdiff_t>((set * dims + d) * n));
    }
  }
  return all;
}

inline Column sobol_columns(unsigned dims, std::uint64_t n) {
  Column points(std::in_place);
  for (unsigned d = 0; d < dims; ++d) {
    const Column column = column_of(TRY_MEASURE(sobol, d, 0, n), n);
    if (!column) return {};
    points->insert(points->end(), column->begin(), column->end());
  }
  return points;
}

/// Task 5.`task`: 3 and 5 shifted, 8 and 9 scrambled.
inline BenchSampler bench_sampler(unsigned task, std::string name) {
  BenchSampler made;
  made.name = std::move(name);
  made.dims = {1, 2, 4, 8};
  made.rounds = [=](std::uint64_t n, std::uint64_t dims, std::uint64_t rounds) {
    return cpu_seconds_of(TRY_MEASURE(repeat_points, task, n, dims, rounds));
  };
  made.points = [=](std::uint64_t n, std::uint64_t dims, std::uint64_t sets, std::uint64_t seed) {
    if (task == 3) {
      const Column points = column_of(TRY_MEASURE(halton, n, dims, 0), n * dims);
      return shifted_sets(points, n, dims, sets, seed);
    }
    if (task == 5) {
      const Column points = sobol_columns(static_cast<unsigned>(dims), n);
      return shifted_sets(points, n, dims, sets, seed);
    }
    constexpr unsigned bases[] = {2, 3, 5, 7, 11, 13, 17, 19};
    return scrambled_sets(n, dims, sets, seed, [&](unsigned d, const auto& seeds) -> Column {
      const std::size_t count = n * seeds.size();
      if (task == 9) {
        return column_of(TRY_MEASURE(radical_inverses_scrambled, bases[d], 0, n, seeds), count);
      }
      const Column column = column_of(TRY_MEASURE(sobol, d, 0, n), n);
      if (!column) return {};
      return column_of(TRY_MEASURE(owen_scramble, *column, seeds), count);
    });
  };
  return made;
}

}  // namespace mc::checks
