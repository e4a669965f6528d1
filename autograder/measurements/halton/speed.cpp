// Lab 5: how fast the speed tasks are, shown below a verdict.

#include "checks/support/catch.hpp"
#include "measurements/halton/methods.hpp"
#include "measurements/support/speed_data.hpp"

namespace mc::measurements {

TEST_CASE("speed of sequences", "[.speed]") {
  const auto time = [](const std::string& task, const Method& column) {
    bench_speed(task, column.name, 4096, column.rounds_of(4096, 1));
  };
  time("5.2", column_of("radical inverses in base 3", 2, 3));
  time("5.5", column_of("Sobol' coordinates", 5, 1));
  time("5.8", column_of("scrambled Sobol' coordinates", 8, 1));
  bench_speed_error("5.8", "scrambled Sobol' coordinates", 1024,
                    method(methods, "scrambled_sobol"));
}

}  // namespace mc::measurements
