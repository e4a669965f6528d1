// 4.7 beside the reference, for the report.

#include "checks/support/catch.hpp"
#include "measurements/blue_noise/bench_samplers.hpp"

namespace mc::checks {

TEST_CASE("speed of blue noise", "[.speed]") {
  const auto samplers = blue_noise_samplers();
  const BenchSampler &candidates = samplers[0], &discs = samplers[1];
  bench_speed("4.7", "best candidates", 256,
              [&](std::uint64_t rounds) { return candidates.rounds(256, 2, rounds); });
  bench_speed_error("4.7", "best candidates", candidates, 256);
  bench_speed("4.7", "Poisson disks", 1024,
              [&](std::uint64_t rounds) { return discs.rounds(1024, 2, rounds); });
}

}  // namespace mc::checks
