// What 2.8 costs, where it passed.

#include "checks/support/catch.hpp"
#include "measurements/independent/timed.hpp"

namespace mc::checks {
namespace {

TEST_CASE("speed of uniforms", "[.speed]") {
  bench_speed("2.8", "uniforms", 4096,
              [](std::uint64_t rounds) { return seconds_of_uniforms(4096, rounds); });
}

}  // namespace
}  // namespace mc::checks
