// Lab 2 in the bench: independent points, and irradiance two ways.

#include <cmath>

#include "2-independent/experiments.hpp"
#include "checks/support/catch.hpp"
#include "checks/support/rect_light_exact.hpp"
#include "measurements/support/bench_data.hpp"

namespace mc::checks {
namespace {

std::vector<BenchSampler> samplers() {
  BenchSampler independent;
  independent.name = "independent";
  independent.dims = {1, 2, 4, 8};
  independent.same_for_all_n = true;
  independent.points = [](std::uint64_t n, std::uint64_t dims, std::uint64_t sets,
                          std::uint64_t seed) -> std::optional<PointSets> {
    const std::vector<std::uint64_t> sizes(sets, n * dims);
    const auto got = TRY_MEASURE(uniforms, seed, sizes, 0);
    const auto* const values = got ? got->if_exactly(sets * n * dims, unit) : nullptr;
    if (values == nullptr) return {};
    return PointSets{n, dims, *values};
  };
  independent.rounds = [](std::uint64_t n, std::uint64_t dims, std::uint64_t rounds) {
    return cpu_seconds_of(TRY_MEASURE(repeat_source, 2, n, dims * rounds, 1));
  };
  return {independent};
}

constexpr const char* ways[] = {"points on the light", "directions"};

TEST_CASE("bench error", "[.bench-error]") {
  bench_errors(samplers());
  const RectLight light;
  const double exact = irradiance(light);
  for (const unsigned way : {0u, 1u}) {
    for (std::uint64_t n = 16; n <= 65536; n *= 4) {
      constexpr std::uint64_t replicates = 200;
      const auto got = way == 0 ? TRY_MEASURE(irradiance_area, light, n, n, replicates)
                                : TRY_MEASURE(irradiance_hemisphere, light, n, n, replicates);
      const auto* const values = got ? got->if_exactly(replicates, any_number) : nullptr;
      if (values == nullptr) break;
      double squares = 0, fourths = 0;
      for (const Estimate& one : *values) {
        const double squared = std::pow(one.value / exact - 1, 2);
        squares += squared / replicates;
        fourths += squared * squared / replicates;
      }
      const double rmse = std::sqrt(squares);
      const double error = std::sqrt((fourths - squares * squares) / replicates) / (2 * rmse);
      bench_row({"error", ways[way], "rectangular light", 2, n, rmse, error});
    }
  }
}

TEST_CASE("bench time", "[.bench-time]") {
  bench_times(samplers());
  for (const unsigned way : {0u, 1u}) {
    constexpr std::uint64_t n = 4096;
    const auto round = seconds_once([&](std::uint64_t rounds) {
      return cpu_seconds_of(TRY_MEASURE(repeat_irradiance, way, n, rounds));
    });
    if (round) bench_row({"time", ways[way], "", 2, n, *round * 1e9 / n});
  }
}

TEST_CASE("bench growth", "[.bench-growth]") {
  for (const BenchSampler& sampler : samplers()) bench_growth_of_dims(sampler);
  bench_growth("independent", 1, 100'000'000, [](std::uint64_t n, std::uint64_t rounds) {
    return used_by(TRY_MEASURE_WITH(large, repeat_source, 2, n, rounds, 1));
  });
}

}  // namespace
}  // namespace mc::checks
