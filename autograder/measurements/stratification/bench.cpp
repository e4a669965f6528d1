// Lab 3 in the bench: growth, and numbers that the handout quotes.

#include <utility>

#include <fmt/format.h>

#include "checks/support/catch.hpp"
#include "measurements/stratification/methods.hpp"
#include "measurements/support/bench_data.hpp"

namespace mc::measurements {
namespace {

TEST_CASE("bench growth", "[.bench-growth]") {
  for (const char* key : {"padded", "latin_hypercube"}) bench_growth_of_dims(methods[key]);
  bench_growth(methods["stratified"], 1, 100'000'000);
  for (const Method& one : methods.of({"jittered", "latin_hypercube", "multi_jittered"})) {
    bench_growth(one, 2, 10'000'000);
  }
}

/// Errors of the two ways of 3.7, and what shared permutations cost beyond the variance
/// (docs/multi-jittered.md).
TEST_CASE("bench table of permutations", "[.bench-table]") {
  for (const auto& [on, name] : {std::pair{"smooth", "bump"}, {"edge", "edge"}}) {
    for (const Count n : {64u, 4096u}) {
      for (const Method& one : methods.of({"jittered", "multi_jittered"})) {
        BenchTable{"RMSE in the cells of a grid"}.add_rmse(
            one.key, fmt::format("{}, N = {}", on, n),
            errors_of(one, integrand(name), n, 2'000, n << 20));
      }
    }
  }
  for (const Count n : {16u, 64u, 256u, 1024u}) {
    for (const auto& [on, name] : {std::pair{"exp(x + y)", "smooth 2D"}, {"the edge", "edge 2D"}}) {
      BenchTable{fmt::format("kurtosis of the error of {}", on), n}.add_kurtosis(
          "multi_jittered",
          errors_of(methods["multi_jittered"], integrand(name), n, 20'000, n << 20));
    }
  }
}

}  // namespace
}  // namespace mc::measurements
