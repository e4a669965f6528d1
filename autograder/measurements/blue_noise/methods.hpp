#pragma once
// Lab 4's methods of making points.

#include "checks/blue_noise/random_sets.hpp"
#include "measurements/support/methods.hpp"

namespace mc::measurements {

inline const std::vector<Method> methods = [] {
  const auto repeated = [](unsigned task) {
    return [=](Count n, Count, Count rounds, const sandbox::Limits&) {
      return Cost(TRY_MEASURE_WITH(large, repeat, task, n, rounds, 1));
    };
  };
  return std::vector<Method>{
      {.key = "best_candidate",
       .task = "4.2",
       .name = "best candidate",
       .points = POINTS_WITH(large, best_candidate, n, 1, count, seed),
       .rounds = repeated(2),
       .dims = {2},
       .most = 1024},  // their time grows as n^2: 400 sets of 1,024 are enough to wait for
      // Ten candidates in the middle of the list: hardly more than a fixed number of them.
      {.key = "few_candidates",
       .task = "4.2",
       .name = "c = 20/N",
       .points = POINTS_WITH(large, best_candidate, n, 20 / static_cast<double>(n), count, seed)},
      {.key = "poisson_disk",
       .task = "4.3",
       .name = "Poisson disk",
       .points =
           [](Count n, Count, Count count, Count seed) {
             const double radius = radius_for(static_cast<double>(n));
             const auto got = TRY_MEASURE_WITH(large, poisson_disk, radius, count, seed);
             return got ? sets_of(patterns_if_any(*got, radius, count)) : Sets{};
           },
       .rounds = repeated(3),
       .dims = {2},
       .most = 16384},
      independent_points(),
      jittered_points()};
}();

}  // namespace mc::measurements
