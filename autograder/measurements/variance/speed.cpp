// How fast 1.8 is.

#include <random>

#include "1-variance/experiments.hpp"
#include "checks/support/catch.hpp"
#include "checks/variance/data_sets.hpp"
#include "measurements/support/speed_data.hpp"

namespace mc::measurements {

TEST_CASE("speed of moments", "[.speed]") {
  Rng rng{std::random_device()()};
  const Values x = uniform_values(rng, 4096, 1e6, 1e6 + 1);  // 32 KB: in the first-level cache
  bench_speed("1.8", "moments", x.size(), [&](std::uint64_t rounds) {
    return cpu_seconds_of(TRY_MEASURE(repeat, 8, x, rounds, 1));
  });
}

}  // namespace mc::measurements
