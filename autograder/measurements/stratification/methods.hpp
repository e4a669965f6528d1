#pragma once
// Lab 3's methods of making points.

#include "3-stratification/experiments.hpp"
#include "measurements/support/methods.hpp"

namespace mc::measurements {

inline const Methods methods = [] {
  // 3.3 and 3.7 make a square number of points: the one near n.
  const auto repeated = [](unsigned task) {
    const bool is_square = task == 3 || task == 7;
    return ROUNDS_BY(repeat, task, is_square ? root(n, 2) * root(n, 2) : n, dims, rounds, 1);
  };
  return Methods{
      {"stratified", "3.1", "jittered", POINTS_BY(stratified_1d, n, count, seed), repeated(1),
       in_bench({1})},
      {"jittered", "3.3", "jittered", POINTS_BY(stratified_2d, squarest(n), count, seed),
       repeated(3), in_bench({2})},
      {"padded", "3.4", "jittered, padded", POINTS_BY(stratified, n, dims, count, seed),
       repeated(4), in_bench({4, 8})},
      {"jittered_nd", "3.5", "jittered in all",
       POINTS_BY(stratified_nd, n, dims, root(n, dims), count, seed), repeated(5),
       in_bench({4}, {.power_of_root = true})},
      {"latin_hypercube", "3.6", "Latin hypercube",
       POINTS_BY(latin_hypercube, n, dims, count, seed), repeated(6), in_bench({2, 4, 8})},
      {"multi_jittered", "3.7", "multi-jittered",
       POINTS_BY(multi_jittered, squarest(n), count, seed), repeated(7), in_bench({2})},
      // To compare with: lab 2's points, and jittered ones by the loop of a textbook.
      {"independent", "2.8", "independent", independent_points.points, repeated(0)},
      {"textbook", "", "loop, std::mt19937_64", jittered_points.points,
       ROUNDS_BY(repeat_textbook, 2, n, rounds)}};
}();

inline const std::vector<SpeedTask> speed_tasks{
    {"3.10", "points of a jittered grid", 1024, methods["jittered"].rounds_of(1024, 2),
     methods["jittered"].points, 1024, methods["textbook"].rounds_of(1024, 2)}};

}  // namespace mc::measurements
