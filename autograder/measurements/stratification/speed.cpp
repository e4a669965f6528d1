// What the speed task of lab 3 is timed at: measured for those who pass it, never graded.

#include "checks/support/catch.hpp"
#include "measurements/stratification/methods.hpp"
#include "measurements/support/speed_data.hpp"

namespace mc::measurements {

TEST_CASE("speed of jittered points", "[.speed]") {
  const std::string name = "points of a jittered grid";
  bench_speed("3.9", name, 1024, method(methods, "jittered").rounds_of(1024, 2));
  bench_speed_error("3.9", name, 1024, method(methods, "jittered"));
}

}  // namespace mc::measurements
