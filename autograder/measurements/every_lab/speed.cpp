// The speed tasks of a lab, where they passed: measured, never graded.

#include "checks/support/catch.hpp"
#include "measurements/support/speed_data.hpp"
#include "methods.hpp"

namespace mc::measurements {

TEST_CASE("speed", "[.speed]") {
  for (const SpeedTask& task : speed_tasks) bench_speed(task);
}

}  // namespace mc::measurements
