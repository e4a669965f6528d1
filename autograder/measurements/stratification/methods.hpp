#pragma once
// Lab 3's methods of making points.

#include "3-stratification/experiments.hpp"
#include "measurements/support/methods.hpp"

namespace mc::measurements {

inline const std::vector<Method> methods = [] {
  const auto way = [](std::string key, unsigned task, std::string name, auto points) {
    return Method{.key = std::move(key),
                  .task = "3." + std::to_string(task),
                  .name = std::move(name),
                  .points = points,
                  .rounds = [=](std::uint64_t n, std::uint64_t dims, std::uint64_t rounds) {
                    return cpu_seconds_of(TRY_MEASURE(repeat, task, n, dims, rounds, 1));
                  }};
  };
  using Count = std::uint64_t;
  std::vector<Method> all{
      way("stratified", 1, "jittered",
          [](Count n, Count, Count count, Count seed) {
            return sets_of(TRY_MEASURE(stratified_1d, n, count, seed), n, 1, count);
          }),
      way("jittered", 3, "jittered",
          [](Count n, Count, Count count, Count seed) {
            return plane_sets_of(TRY_MEASURE(stratified_2d, squarest(n), count, seed), n, count);
          }),
      way("padded", 4, "jittered, padded",
          [](Count n, Count dims, Count count, Count seed) {
            return sets_of(TRY_MEASURE(stratified, n, dims, count, seed), n, dims, count);
          }),
      way("jittered_nd", 5, "jittered in all",
          [](Count n, Count dims, Count count, Count seed) {
            const auto got = TRY_MEASURE(stratified_nd, n, dims, root(n, dims), count, seed);
            return sets_of(got, n, dims, count);
          }),
      way("latin_hypercube", 6, "Latin hypercube",
          [](Count n, Count dims, Count count, Count seed) {
            return sets_of(TRY_MEASURE(latin_hypercube, n, dims, count, seed), n, dims, count);
          }),
      way("multi_jittered", 7, "multi-jittered",
          [](Count n, Count, Count count, Count seed) {
            return plane_sets_of(TRY_MEASURE(multi_jittered, squarest(n), count, seed), n, count);
          }),
      // To compare with: lab 2's points, and jittered ones by the loop of a textbook.
      way("independent", 0, "independent", independent_points().points),
      way("textbook", 3, "loop, std::mt19937_64", jittered_points().points)};
  all[0].dims = {1};
  all[2].dims = {4, 8};
  all[3].dims = {4};
  all[3].power_of_root = true;
  all[4].dims = {2, 4, 8};
  all[6].task = "2.8";
  all[7].task = "";
  all[7].rounds = [](std::uint64_t n, std::uint64_t, std::uint64_t rounds) {
    return cpu_seconds_of(TRY_MEASURE(repeat_textbook, 2, n, rounds));
  };
  return all;
}();

}  // namespace mc::measurements
