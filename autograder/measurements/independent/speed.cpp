// What 2.8 costs, where it passed.

#include "2-independent/experiments.hpp"
#include "checks/support/catch.hpp"
#include "measurements/support/plot_data.hpp"
#include "measurements/support/speed_data.hpp"

namespace mc::checks {
namespace {

TEST_CASE("speed of uniforms", "[.speed]") {
  bench_speed("2.8", "uniforms", 4096, [](std::uint64_t rounds) {
    return cpu_seconds_of(TRY_MEASURE(repeat_source, 2, 4096, rounds, 1));
  });
}

}  // namespace
}  // namespace mc::checks
