#pragma once
// Lab 4's methods of making points.

#include "checks/blue_noise/random_sets.hpp"
#include "measurements/support/methods.hpp"

namespace mc::measurements {

inline const std::vector<Method> methods = [] {
  using Count = std::uint64_t;
  const auto way = [](std::string key, unsigned task, std::string name, Count most, auto points) {
    return Method{.key = std::move(key),
                  .task = "4." + std::to_string(task),
                  .name = std::move(name),
                  .points = points,
                  .rounds =
                      [=](Count n, Count, Count rounds) {
                        return cpu_seconds_of(TRY_MEASURE_WITH(large, repeat, task, n, rounds, 1));
                      },
                  .most = most};
  };
  const auto candidates = [](double c_times_n, double c) {
    return [=](Count n, Count, Count count, Count seed) {
      const double per_point = c + c_times_n / static_cast<double>(n);
      return plane_sets_of(TRY_MEASURE_WITH(large, best_candidate, n, per_point, count, seed), n,
                           count);
    };
  };
  return std::vector<Method>{
      // Their time grows as n^2: 400 sets of 1,024 are enough to wait for.
      way("best_candidate", 2, "best candidate", 1024, candidates(0, 1)),
      // Ten candidates in the middle of the list: hardly more than a fixed number of them.
      way("few_candidates", 2, "c = 20/N", 1024, candidates(20, 0)),
      way("poisson_disk", 3, "Poisson disk", 16384,
          [](Count n, Count, Count count, Count seed) {
            const double radius = radius_for(static_cast<double>(n));
            const auto got = TRY_MEASURE_WITH(large, poisson_disk, radius, count, seed);
            Sets sets;
            if (!got) return sets;
            const SampleSets all = patterns_if_any(*got, radius, count);
            for (std::size_t set = 0; set < all.size(); ++set) {
              sets.emplace_back(all.points(set), 2);
              for (const std::size_t d : {0u, 1u}) {
                const View from = all.column(set, d);
                std::copy(from.begin(), from.end(), sets.back().column(d).begin());
              }
            }
            return sets;
          }),
      independent_points(), jittered_points()};
}();

}  // namespace mc::measurements
