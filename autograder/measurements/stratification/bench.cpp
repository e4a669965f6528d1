// Lab 3 in the bench: jittered points, padded ones, grids in all dimensions, Latin
// hypercubes.

#include <utility>

#include <fmt/format.h>

#include "checks/support/catch.hpp"
#include "measurements/stratification/methods.hpp"
#include "measurements/support/bench_data.hpp"

namespace mc::measurements {
namespace {

TEST_CASE("bench error", "[.bench-error]") {
  bench_errors(methods);
}
TEST_CASE("bench time", "[.bench-time]") {
  bench_times(methods);
}
TEST_CASE("bench growth", "[.bench-growth]") {
  for (const char* key : {"padded", "latin_hypercube"}) bench_growth_of_dims(method(methods, key));
  bench_growth(method(methods, "stratified"), 1, 100'000'000);
  for (const char* key : {"jittered", "latin_hypercube", "multi_jittered"}) {
    bench_growth(method(methods, key), 2, 10'000'000);
  }
}

/// Errors of the two ways of 3.7, and what shared permutations cost beyond the variance
/// (docs/multi-jittered.md).
TEST_CASE("bench table of permutations", "[.bench-table]") {
  const BenchTable table("RMSE in the cells of a grid");
  for (const auto& [on, name] : {std::pair{"smooth", "bump"}, {"edge", "edge"}}) {
    for (const Count n : {64u, 4096u}) {
      for (const char* key : {"jittered", "multi_jittered"}) {
        table.add_rmse(key, fmt::format("{}, N = {}", on, n),
                       errors_of(method(methods, key), integrand(name), n, 2'000, n << 20));
      }
    }
  }
  for (const Count n : {16u, 64u, 256u, 1024u}) {
    for (const auto& [on, name] : {std::pair{"exp(x + y)", "smooth 2D"}, {"the edge", "edge 2D"}}) {
      BenchTable(fmt::format("kurtosis of the error of {}", on))
          .add_kurtosis(
              "multi_jittered", fmt::format("N = {}", n),
              errors_of(method(methods, "multi_jittered"), integrand(name), n, 20'000, n << 20), n);
    }
  }
}

}  // namespace
}  // namespace mc::measurements
