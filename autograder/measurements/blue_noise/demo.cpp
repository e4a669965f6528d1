// Lab 4 in the demo: blue noise.

#include "measurements/support/demo.hpp"
#include "checks/support/catch.hpp"
#include "measurements/blue_noise/methods.hpp"

namespace mc::measurements {
namespace {

TEST_CASE("demo", "[.demo]") {
  begin_demo();
  for (const char* key : {"best_candidate", "poisson_disk"}) {
    write_demo_points(4, method(methods, key));
  }
}

}  // namespace
}  // namespace mc::measurements
