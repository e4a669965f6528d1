// Lab 3 in the bench: jittered points, padded ones, grids in all dimensions, Latin hypercubes.

#include <cmath>

#include "3-stratification/experiments.hpp"
#include "checks/support/bench_data.hpp"
#include "checks/support/catch.hpp"

namespace mc::checks {
namespace {

using Columns = std::optional<PointSets>;

std::uint64_t root(std::uint64_t n, std::uint64_t d) {
  return static_cast<std::uint64_t>(
      std::llround(std::pow(static_cast<double>(n), 1 / static_cast<double>(d))));
}

template <class Measured>
Columns columns_of(std::uint64_t n, std::uint64_t dims, Measured&& measured) {
  if (!measured) return {};
  return PointSets{n, dims, std::move(measured->value)};
}

/// Sets of x and y side by side.
template <class Measured>
Columns planes_of(std::uint64_t n, const Measured& measured) {
  if (!measured) return {};
  PointSets sets{n, 2, {}};
  const auto &x = measured->value.x, &y = measured->value.y;
  for (std::size_t first = 0; first + n <= std::min(x.size(), y.size()); first += n) {
    const auto at = static_cast<std::ptrdiff_t>(first),
               end = static_cast<std::ptrdiff_t>(first + n);
    sets.values.insert(sets.values.end(), x.begin() + at, x.begin() + end);
    sets.values.insert(sets.values.end(), y.begin() + at, y.begin() + end);
  }
  return sets;
}

/// What makes the points of task 3.`task`.
Columns points_of(unsigned task, std::uint64_t n, std::uint64_t dims, std::uint64_t sets,
                  std::uint64_t seed) {
  const Grid grid{root(n, 2), root(n, 2)};
  switch (task) {
    case 1:
      return columns_of(n, 1, TRY_MEASURE(stratified_1d, n, sets, seed));
    case 3:
      return planes_of(n, TRY_MEASURE(stratified_2d, grid, sets, seed));
    case 4:
      return columns_of(n, dims, TRY_MEASURE(stratified, n, dims, sets, seed));
    case 5:
      return columns_of(n, dims, TRY_MEASURE(stratified_nd, n, dims, root(n, dims), sets, seed));
    case 6:
      return columns_of(n, dims, TRY_MEASURE(latin_hypercube, n, dims, sets, seed));
    default:
      return planes_of(n, TRY_MEASURE(multi_jittered, grid, sets, seed));
  }
}

BenchSampler sampler(unsigned task, std::string name, std::vector<std::uint64_t> dims) {
  BenchSampler made{std::move(name), std::move(dims)};
  made.power_of_root = task == 5;
  made.points = [=](std::uint64_t n, std::uint64_t d, std::uint64_t sets, std::uint64_t seed) {
    return points_of(task, n, d, sets, seed);
  };
  made.rounds = [=](std::uint64_t n, std::uint64_t d, std::uint64_t rounds) {
    return cpu_seconds_of(TRY_MEASURE(repeat, task, n, d, rounds));
  };
  return made;
}

std::vector<BenchSampler> samplers() {
  return {sampler(1, "jittered", {1}),
          sampler(3, "jittered", {2}),
          sampler(4, "jittered, padded", {4, 8}),
          sampler(5, "jittered in all", {4}),
          sampler(6, "Latin hypercube", {2, 4, 8}),
          sampler(7, "multi-jittered", {2})};
}

TEST_CASE("bench error", "[.bench-error]") {
  bench_errors(samplers());
}
TEST_CASE("bench time", "[.bench-time]") {
  bench_times(samplers());
}
TEST_CASE("bench growth", "[.bench-growth]") {
  for (const unsigned task : {4u, 6u}) {
    bench_growth_of_dims(sampler(task, task == 4 ? "jittered, padded" : "Latin hypercube", {}));
  }
  const auto grow = [](const char* name, unsigned task, std::uint64_t dims, std::uint64_t most) {
    bench_growth(name, dims, most, [=](std::uint64_t n, std::uint64_t rounds) {
      // A square number near it, where a square is wanted.
      const std::uint64_t size = task == 3 || task == 7 ? root(n, 2) * root(n, 2) : n;
      return used_by(TRY_MEASURE_WITH(large, repeat, task, size, dims, rounds));
    });
  };
  grow("jittered", 1, 1, 100'000'000);
  grow("jittered", 3, 2, 10'000'000);
  grow("Latin hypercube", 6, 2, 10'000'000);
  grow("multi-jittered", 7, 2, 10'000'000);
}

TEST_CASE("speed of jittered points", "[.speed]") {
  const BenchSampler jittered = sampler(3, "jittered", {2});
  bench_speed("3.9", "points of a jittered grid", 1024,
              [&](std::uint64_t rounds) { return jittered.rounds(1024, 2, rounds); });
  bench_speed_error("3.9", "points of a jittered grid", jittered, 1024);
}

}  // namespace
}  // namespace mc::checks
