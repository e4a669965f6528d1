// What 2.8 costs, where it passed.

#include <cmath>

#include "2-independent/experiments.hpp"
#include "checks/support/bench_data.hpp"
#include "checks/support/catch.hpp"

namespace mc::checks {
namespace {

TEST_CASE("speed of uniforms", "[.speed]") {
  bench_speed("2.8", "uniforms", 4096, [](std::uint64_t rounds) -> std::optional<double> {
    const auto got = TRY_MEASURE(repeat_source, 2, 4096, rounds);
    if (!got) return {};
    // Every round makes new numbers: one of each is looked at, and has the mean 1/2 within eight
    // standard errors (1e-15) of 1 / sqrt(12 rounds).
    const double error = 1 / std::sqrt(12 * static_cast<double>(rounds));
    const bool new_ones = got->value.unchanged < 2 && std::abs(got->value.mean - 0.5) < 8 * error;
    if (!new_ones) return {};
    return got->cpu_seconds;
  });
}

}  // namespace
}  // namespace mc::checks
