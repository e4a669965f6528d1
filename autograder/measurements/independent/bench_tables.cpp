// Lab 2 in the bench: figures that the handout quotes.

#include <cmath>

#include "2-independent/experiments.hpp"
#include "checks/support/catch.hpp"
#include "common/normal_quantile.hpp"
#include "measurements/support/bench_data.hpp"

namespace mc::checks {
namespace {

/// The sixty estimates of the picture of intervals, by its seed.
TEST_CASE("bench table of intervals", "[.bench-table]") {
  const double z = normal_quantile(0.975);
  const auto write = [&](const char* row, const experiments::Function& g, double mean) {
    const auto got = TRY_MEASURE(estimates, g, 1000, 1, 60);
    const auto* const all = got ? got->if_exactly(60) : nullptr;
    if (all == nullptr) return;
    double misses = 0;
    for (const auto& one : *all) misses += std::abs(one.value - mean) > z * one.standard_error;
    bench_table({"95 % intervals that miss, of 60", row, "misses", 0, misses});
  };
  write("exp(x)", {1, 0, 1, 0}, std::expm1(1.0));
  write("x^-0.75", {4, -0.75, 1, 0}, 4);
}

}  // namespace
}  // namespace mc::checks
