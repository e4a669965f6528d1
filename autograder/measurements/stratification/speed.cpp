// What the speed task of lab 3 is timed at: measured for those who pass it, never graded.

#include "checks/support/catch.hpp"
#include "measurements/stratification/methods.hpp"
#include "measurements/support/speed_data.hpp"

namespace mc::measurements {

TEST_CASE("speed of jittered points", "[.speed]") {
  bench_speed("3.9", "points of a jittered grid", 1024, method(methods, "jittered"));
}

}  // namespace mc::measurements
