#pragma once
// Best candidates and Poisson disks as the bench sees them.

#include <optional>
#include <string>
#include <vector>

#include "checks/blue_noise/patterns.hpp"
#include "measurements/support/bench_data.hpp"

namespace mc::checks {

/// CPU time of making patterns.
inline std::optional<double> seconds_of_patterns(unsigned task, std::uint64_t n,
                                                 std::uint64_t rounds) {
  return cpu_seconds_of(TRY_MEASURE_WITH(large, repeat, task, n, rounds, 1));
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
