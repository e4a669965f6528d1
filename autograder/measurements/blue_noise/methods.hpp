#pragma once
// Lab 4's methods of making points.

#include "checks/blue_noise/random_sets.hpp"
#include "measurements/support/methods.hpp"

namespace mc::measurements {

/// The patterns of an answer; none if it is invalid.
inline SampleSets patterns_if_any(const Measured<experiments::Patterns>& got, double radius,
                                  std::size_t sets) {
  const auto* const all = got.if_list_by_list(patterns_spec(radius, sets));
  return patterns_in(got.call, all == nullptr ? experiments::Patterns{} : *all);
}

inline const Methods methods = [] {
  const auto repeated = [](unsigned task) {
    return [=](Count n, Count, Count rounds, const sandbox::Limits&) {
      return Cost(TRY_MEASURE_WITH(large, repeat, task, n, rounds, 1));
    };
  };
  const auto disks = [](Count n, Count, Count count, Count seed) {
    const double radius = radius_for(static_cast<double>(n));
    const auto got = TRY_MEASURE_WITH(large, poisson_disk, radius, count, seed);
    return got ? sets_of(patterns_if_any(*got, radius, count)) : Sets{};
  };
  return Methods{
      // Their time grows as n^2: 400 sets of 1,024 are enough to wait for.
      {"best_candidate", "4.2", "best candidate",
       POINTS_WITH(large, best_candidate, n, 1, count, seed), repeated(2),
       in_bench({2}, {.most = 1024})},
      // Ten candidates in the middle of the list: hardly more than a fixed number of them.
      {"few_candidates", "4.2", "c = 20/N",
       POINTS_WITH(large, best_candidate, n, 20 / static_cast<double>(n), count, seed)},
      {"poisson_disk", "4.3", "Poisson disk", disks, repeated(3), in_bench({2}, {.most = 16384})},
      independent_points,
      jittered_points};
}();

inline Rounds plain_by(unsigned task, Count n) {
  return [=](Count rounds) { return TRY_MEASURE(repeat_plain, task, n, rounds, 1); };
}

/// 256 points of either: the plain darts take n^2, 0.1 s for 1,024.
inline const std::vector<SpeedTask> speed_tasks{
    {"4.7", "best candidates", 256, methods["best_candidate"].rounds_of(256, 2),
     methods["best_candidate"].points, 256, plain_by(2, 256)},
    {"4.7",
     "Poisson disks",
     256,
     methods["poisson_disk"].rounds_of(256, 2),
     {},
     0,
     plain_by(3, 256)}};

}  // namespace mc::measurements
