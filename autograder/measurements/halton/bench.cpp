// Lab 5 in the bench: Halton and Sobol' points, shifted and scrambled.

#include <tuple>

#include "checks/support/catch.hpp"
#include "measurements/halton/bench_samplers.hpp"

namespace mc::checks {
namespace {

std::vector<BenchSampler> samplers() {
  return {bench_sampler(3, "Halton, shifted"), bench_sampler(9, "Halton, scrambled"),
          bench_sampler(5, "Sobol', shifted"), bench_sampler(8, "Sobol', scrambled")};
}

TEST_CASE("bench error", "[.bench-error]") {
  bench_errors(samplers());
}
TEST_CASE("bench time", "[.bench-time]") {
  bench_times(samplers());
}
TEST_CASE("bench growth", "[.bench-growth]") {
  for (const BenchSampler& one : samplers()) bench_growth_of_dims(one);
  // Columns of one axis, which nobody cuts into blocks.
  for (const auto& [name, task, of] : {std::tuple{"5.2 radical inverses, base 3", 2u, 3u},
                                       {"5.5 Sobol', dimension 1", 5u, 1u},
                                       {"5.8 the same, scrambled", 8u, 1u},
                                       {"5.9 scrambled radical inverses, base 3", 9u, 3u}}) {
    bench_growth(name, 1, 100'000'000,
                 [task = task, of = of](std::uint64_t n, std::uint64_t rounds) {
                   return used_by(TRY_MEASURE_WITH(large, repeat, task, of, n, rounds, 1));
                 });
  }
}

}  // namespace
}  // namespace mc::checks
