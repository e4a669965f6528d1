// What 2.8 costs, where it passed.

#include "checks/independent/timed.hpp"
#include "checks/support/catch.hpp"

namespace mc::checks {
namespace {

TEST_CASE("speed of uniforms", "[.speed]") {
  bench_speed("2.8", "uniforms", 4096,
              [](std::uint64_t rounds) { return seconds_of_uniforms(4096, rounds); });
}

}  // namespace
}  // namespace mc::checks
