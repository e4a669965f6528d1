// 4.7 next to the reference, for the report.

#include "checks/support/catch.hpp"
#include "measurements/blue_noise/methods.hpp"
#include "measurements/support/speed_data.hpp"

namespace mc::measurements {

TEST_CASE("speed of blue noise", "[.speed]") {
  const Method &candidates = method(methods, "best_candidate"),
               &disks = method(methods, "poisson_disk");
  bench_speed("4.7", "best candidates", 256, candidates.rounds_of(256, 2));
  bench_speed_error("4.7", "best candidates", 256, candidates);
  bench_speed("4.7", "Poisson disks", 1024, disks.rounds_of(1024, 2));
}

}  // namespace mc::measurements
