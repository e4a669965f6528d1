// Lab 3 in the bench: jittered points, padded ones, grids in all dimensions, Latin
// hypercubes.

#include <utility>

#include <fmt/format.h>

#include "checks/support/catch.hpp"
#include "measurements/stratification/methods.hpp"
#include "measurements/support/bench_data.hpp"

namespace mc::measurements {
namespace {

std::vector<Method> benched() {
  return methods_of(methods, {"stratified", "jittered", "padded", "jittered_nd", "latin_hypercube",
                              "multi_jittered"});
}

TEST_CASE("bench error", "[.bench-error]") {
  bench_errors(benched());
}
TEST_CASE("bench time", "[.bench-time]") {
  bench_times(benched());
}
TEST_CASE("bench growth", "[.bench-growth]") {
  for (const Method& one : methods_of(methods, {"padded", "latin_hypercube"})) {
    bench_growth_of_dims(one.name, one);
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

/// Errors of the two ways of 3.7, and what shared permutations cost beyond the variance
/// (docs/multi-jittered.md).
TEST_CASE("bench table of permutations", "[.bench-table]") {
  for (const auto& [on, g] :
       {std::pair{"smooth", integrand("bump")}, {"edge", integrand("edge")}}) {
    for (const std::uint64_t n : {64u, 4096u}) {
      for (const char* name : {"jittered", "multi_jittered"}) {
        bench_table("RMSE in the cells of a grid", name, fmt::format("{}, N = {}", on, n), 0,
                    errors_of(method(methods, name), g, n, 2'000, n << 20));
      }
    }
  }
  for (const std::uint64_t n : {16u, 64u, 256u, 1024u}) {
    for (const auto& [on, name] : {std::pair{"exp(x + y)", "smooth 2D"}, {"the edge", "edge 2D"}}) {
      const ErrorSums errors =
          errors_of(method(methods, "multi_jittered"), integrand(name), n, 20'000, n << 20);
      if (errors.count == 0) return;
      bench_table({fmt::format("kurtosis of the error of {}", on), "multi_jittered",
                   fmt::format("N = {}", n), n, errors.kurtosis(), errors.kurtosis_error()});
    }
  }
}

}  // namespace
}  // namespace mc::measurements
