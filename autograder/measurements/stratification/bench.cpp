// Lab 3 in the bench: numbers that documents show.

#include "checks/support/catch.hpp"
#include "measurements/stratification/methods.hpp"
#include "measurements/support/bench_data.hpp"

namespace mc::measurements {
namespace {

/// What shared permutations cost beyond the variance (docs/multi-jittered.md).
TEST_CASE("bench table of permutations", "[.bench-table]") {
  const Method& method = methods["multi_jittered"];
  for (const Count n : {16u, 64u, 256u, 1024u}) {
    BenchTable{"kurtosis of the error of exp(x + y)", n}.add_kurtosis(
        method.key, errors_of(method, integrand("smooth 2D"), n, 20'000, n << 20));
  }
}

}  // namespace
}  // namespace mc::measurements
