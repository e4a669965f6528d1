// How fast 1.8 is.

#include <random>

#include "checks/support/catch.hpp"
#include "measurements/support/speed_data.hpp"
#include "measurements/variance/methods.hpp"

namespace mc::measurements {

TEST_CASE("speed of moments", "[.speed]") {
  Rng rng{std::random_device()()};
  const Values x = uniform_values(rng, 4096, 1e6, 1e6 + 1);  // 32 KB: in the first-level cache
  bench_speed("1.8", "moments", x.size(), rounds_over(x, 8));
}

}  // namespace mc::measurements
