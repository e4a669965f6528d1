// Lab 2 in the bench and in the demo: independent points, and irradiance two ways; and numbers that
// the handout quotes.

#include <cmath>

#include "checks/support/catch.hpp"
#include "common/normal_quantile.hpp"
#include "measurements/independent/methods.hpp"
#include "measurements/support/bench_data.hpp"
#include "measurements/support/demo.hpp"

namespace mc::measurements {
namespace {

TEST_CASE("bench error", "[.bench-error]") {
  bench_errors({uniform_points});
  for (const unsigned way : {0u, 1u}) {
    for (Count n = 16; n <= 65536; n *= 4) {
      const ErrorSums errors = irradiance_errors(way, n, 200, n);
      if (errors.count == 0) break;
      bench_error(light_ways[way], "rectangular light", 2, n, errors, irradiance(RectLight{}));
    }
  }
}

TEST_CASE("bench time", "[.bench-time]") {
  bench_times({uniform_points});
  for (const unsigned way : {0u, 1u}) {
    bench_time(light_ways[way], "", 2, 4096, [&](Count rounds) {
      return cpu_seconds_of(TRY_MEASURE(repeat_irradiance, way, 4096, rounds));
    });
  }
}

TEST_CASE("bench growth", "[.bench-growth]") {
  bench_growth_of_dims("independent", uniform_points);
  bench_growth("independent", 1, 100'000'000, [](Count n, Count rounds) {
    return used_by(TRY_MEASURE_WITH(large, repeat_source, 2, n, rounds, 1));
  });
}

/// The sixty estimates of the picture of intervals, by its seed.
TEST_CASE("bench table of intervals", "[.bench-table]") {
  const double z = normal_quantile(0.975);
  for (const std::size_t i : {0u, 4u}) {
    const auto got = TRY_MEASURE(estimates, line_integrands[i].g, 1000, 1, 60);
    const auto* const all = got ? got->if_exactly(60) : nullptr;
    if (all == nullptr) return;
    double misses = 0;
    for (const auto& one : *all) {
      misses += std::abs(one.value - line_integrands[i].mean) > z * one.standard_error;
    }
    bench_table({"95 % intervals that miss, of 60", line_integrands[i].name, "misses", 0, misses});
  }
}

TEST_CASE("demo", "[.demo]") {
  write_demo(1, uniform_points);
}

}  // namespace
}  // namespace mc::measurements
