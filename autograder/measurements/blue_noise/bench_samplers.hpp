#pragma once
// Best candidates and Poisson disks as the bench sees them.

#include <optional>
#include <string>
#include <vector>

#include "checks/blue_noise/patterns.hpp"
#include "measurements/support/bench_data.hpp"

namespace mc::checks {

/// Task 4.`task`, 2 or 3, for about n points: x and then y of the pattern that a seed gives.
inline std::vector<double> judged_pattern(unsigned task, std::uint64_t n, std::uint64_t seed) {
  std::vector<double> all;
  const auto append = [&](const auto& points) {
    all = points.x;
    all.insert(all.end(), points.y.begin(), points.y.end());
  };
  if (task == 2) {
    const auto got = TRY_MEASURE_WITH(large, best_candidate, n, 1, 1, seed);
    if (const auto* const points = got ? got->if_exactly(n, unit) : nullptr) append(*points);
  } else {
    const double radius = radius_for(static_cast<double>(n));
    const auto got = TRY_MEASURE_WITH(large, poisson_disk, radius, 1, seed);
    const auto [x, y, sizes] = patterns_due(radius, 1);
    const auto* const points = got ? got->if_list_by_list({x, y, sizes}) : nullptr;
    if (points != nullptr) append(*points);
  }
  return all;
}

/// CPU time of making patterns: each round made what its seed gives elsewhere.
inline std::optional<double> seconds_of_patterns(unsigned task, std::uint64_t n,
                                                 std::uint64_t rounds) {
  const ShownRounds some = shown_rounds(rounds, 2 * n);
  const auto timed = TRY_MEASURE_WITH(large, repeat, task, n, rounds, some.seed, some.shown);
  if (!timed) return {};
  const std::vector<Set> patterns =
      patterns_if_any(*timed, radius_for(static_cast<double>(n)), some.shown.size());
  if (patterns.size() != some.shown.size()) throw WrongWhenTimed{"not as many patterns as are due"};
  for (std::size_t i = 0; i < patterns.size(); ++i) {
    std::vector<double> made(patterns[i].x.begin(), patterns[i].x.end());
    made.insert(made.end(), patterns[i].y.begin(), patterns[i].y.end());
    const ShownRounds one{some.seed, {some.shown[i]}, {some.seeds[i]}};
    expect_as_judged(one, &made, judged_pattern(task, n, some.seeds[i]));
  }
  return timed->cpu_seconds;
}

inline std::vector<BenchSampler> blue_noise_samplers() {
  const auto way = [](unsigned task, std::string name, std::uint64_t most) {
    BenchSampler made;
    made.name = std::move(name);
    made.dims = {2};
    made.most = most;
    made.rounds = [=](std::uint64_t n, std::uint64_t, std::uint64_t rounds) {
      return seconds_of_patterns(task, n, rounds);
    };
    return made;
  };
  // Best candidates take a time that grows as n^2: 400 sets of 1,024 are enough to wait for.
  BenchSampler candidates = way(2, "best candidate", 1024), discs = way(3, "Poisson disk", 16384);
  candidates.points = [](std::uint64_t n, std::uint64_t, std::uint64_t sets,
                         std::uint64_t seed) -> std::optional<PointSets> {
    const auto got = TRY_MEASURE_WITH(large, best_candidate, n, 1, sets, seed);
    const auto* const points = got ? got->if_exactly(n * sets, unit) : nullptr;
    if (points == nullptr) return {};
    PointSets all{n, 2, {}};
    for (std::size_t set = 0; set < sets; ++set) {
      for (const auto* column : {&points->x, &points->y}) {
        const View part = View(*column).subspan(set * n, n);
        all.values.insert(all.values.end(), part.begin(), part.end());
      }
    }
    return all;
  };
  return {candidates, discs};
}

}  // namespace mc::checks
