// What the speed task of lab 3 is timed at: measured for those who pass it, never graded.

#include "checks/support/catch.hpp"
#include "measurements/stratification/samplers.hpp"

namespace mc::checks {
namespace {

TEST_CASE("speed of jittered points", "[.speed]") {
  const BenchSampler jittered = sampler(3, "jittered", {2});
  bench_speed("3.9", "points of a jittered grid", 1024,
              [&](std::uint64_t rounds) { return jittered.rounds(1024, 2, rounds); });
  bench_speed_error("3.9", "points of a jittered grid", jittered, 1024);
}

}  // namespace
}  // namespace mc::checks
