// The speed task of lab 1.

#include "1-variance/experiments.hpp"
#include "checks/support/catch.hpp"
#include "checks/support/plot_data.hpp"
#include "checks/support/speed_data.hpp"

namespace mc::checks {
namespace {

TEST_CASE("speed of moments", "[.speed]") {
  bench_speed("1.8", "moments", 4096, [](std::uint64_t rounds) {
    return cpu_seconds_of(TRY_MEASURE(repeat_made, 8, 4096, rounds));
  });
}

}  // namespace
}  // namespace mc::checks
