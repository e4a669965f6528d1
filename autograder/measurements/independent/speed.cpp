// What 2.8 costs, where it passed.

#include "checks/support/catch.hpp"
#include "measurements/independent/methods.hpp"
#include "measurements/support/speed_data.hpp"

namespace mc::measurements {

TEST_CASE("speed of uniforms", "[.speed]") {
  bench_speed("2.8", "uniforms", 4096, uniform_points.rounds_of(4096, 1));
}

}  // namespace mc::measurements
