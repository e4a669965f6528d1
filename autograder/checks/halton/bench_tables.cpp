// Lab 5 in the bench: figures of which there are few enough for a table.

#include <string>

#include "checks/halton/tails.hpp"
#include "checks/support/catch.hpp"

namespace mc::checks {
namespace {

TEST_CASE("bench table", "[.bench-table]") {
  for (std::size_t n = 16; n <= 4096; n *= 4) {
    const auto errors = errors_of_exp(n, 20'000);
    if (!errors) return;
    bench_table({"kurtosis of the error of exp(x) on the line, Sobol' points scrambled by 5.8",
                 "owen_scramble", "N = " + std::to_string(n), n, errors->kurtosis(),
                 std::sqrt(24 / errors->count)});
  }
}

}  // namespace
}  // namespace mc::checks
