// Lab 3 in the bench: jittered points, padded ones, grids in all dimensions, Latin hypercubes.

#include "checks/support/catch.hpp"
#include "measurements/stratification/samplers.hpp"

namespace mc::checks {
namespace {

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
      return used_by(TRY_MEASURE_WITH(large, repeat, task, size, dims, rounds, 1));
    });
  };
  grow("jittered", 1, 1, 100'000'000);
  grow("jittered", 3, 2, 10'000'000);
  grow("Latin hypercube", 6, 2, 10'000'000);
  grow("multi-jittered", 7, 2, 10'000'000);
}

}  // namespace
}  // namespace mc::checks
