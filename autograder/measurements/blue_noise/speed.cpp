// 4.7 next to the reference, for the report.

#include "checks/support/catch.hpp"
#include "measurements/blue_noise/methods.hpp"
#include "measurements/support/speed_data.hpp"

namespace mc::measurements {

TEST_CASE("speed of blue noise", "[.speed]") {
  bench_speed("4.7", "best candidates", 256, method(methods, "best_candidate"));
  bench_speed("4.7", "Poisson disks", 1024, [](std::uint64_t rounds) {
    return method(methods, "poisson_disk").rounds(1024, 2, rounds);
  });
}

}  // namespace mc::measurements
