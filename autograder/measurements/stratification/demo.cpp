// Lab 3 in the demo: points of the plane.

#include "measurements/support/demo.hpp"
#include "checks/support/catch.hpp"
#include "measurements/stratification/methods.hpp"

namespace mc::measurements {
namespace {

TEST_CASE("demo", "[.demo]") {
  begin_demo();
  for (const char* key : {"jittered", "latin_hypercube", "multi_jittered"}) {
    write_demo_points(3, method(methods, key));
  }
}

}  // namespace
}  // namespace mc::measurements
