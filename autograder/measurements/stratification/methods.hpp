#pragma once
// Lab 3's methods of making points.

#include "3-stratification/experiments.hpp"
#include "measurements/support/methods.hpp"

namespace mc::measurements {

inline const std::vector<Method> methods = [] {
  // 3.3 and 3.7 make a square number of points: the one near n.
  const auto repeated = [](unsigned task) {
    const bool is_square = task == 3 || task == 7;
    return ROUNDS_BY(repeat, task, is_square ? root(n, 2) * root(n, 2) : n, dims, rounds, 1);
  };
  return std::vector<Method>{
      {.key = "stratified",
       .task = "3.1",
       .name = "jittered",
       .points = POINTS_BY(stratified_1d, n, count, seed),
       .rounds = repeated(1),
       .dims = {1}},
      {.key = "jittered",
       .task = "3.3",
       .name = "jittered",
       .points = POINTS_BY(stratified_2d, squarest(n), count, seed),
       .rounds = repeated(3),
       .dims = {2}},
      {.key = "padded",
       .task = "3.4",
       .name = "jittered, padded",
       .points = POINTS_BY(stratified, n, dims, count, seed),
       .rounds = repeated(4),
       .dims = {4, 8}},
      {.key = "jittered_nd",
       .task = "3.5",
       .name = "jittered in all",
       .points = POINTS_BY(stratified_nd, n, dims, root(n, dims), count, seed),
       .rounds = repeated(5),
       .dims = {4},
       .power_of_root = true},
      {.key = "latin_hypercube",
       .task = "3.6",
       .name = "Latin hypercube",
       .points = POINTS_BY(latin_hypercube, n, dims, count, seed),
       .rounds = repeated(6),
       .dims = {2, 4, 8}},
      {.key = "multi_jittered",
       .task = "3.7",
       .name = "multi-jittered",
       .points = POINTS_BY(multi_jittered, squarest(n), count, seed),
       .rounds = repeated(7),
       .dims = {2}},
      // To compare with: lab 2's points, and jittered ones by the loop of a textbook.
      {.key = "independent",
       .task = "2.8",
       .name = "independent",
       .points = independent_points().points,
       .rounds = repeated(0)},
      {.key = "textbook",
       .task = "",
       .name = "loop, std::mt19937_64",
       .points = jittered_points().points,
       .rounds = ROUNDS_BY(repeat_textbook, 2, n, rounds)}};
}();

}  // namespace mc::measurements
