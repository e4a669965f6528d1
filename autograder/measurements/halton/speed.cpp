// Lab 5: how fast the speed tasks are, shown below a verdict.

#include "checks/support/catch.hpp"
#include "measurements/halton/methods.hpp"
#include "measurements/support/speed_data.hpp"

namespace mc::measurements {

TEST_CASE("speed of sequences", "[.speed]") {
  const auto column = [](unsigned task, unsigned of) {
    return [=](Count rounds) {
      return cpu_seconds_of(TRY_MEASURE(repeat, task, of, 4096, rounds, 1));
    };
  };
  bench_speed("5.2", "radical inverses in base 3", 4096, column(2, 3));
  bench_speed("5.5", "Sobol' coordinates", 4096, column(5, 1));
  bench_speed("5.8", "scrambled Sobol' coordinates", 4096, column(8, 1));
  bench_speed_error("5.8", "scrambled Sobol' coordinates", 1024,
                    method(methods, "scrambled_sobol"));
}

}  // namespace mc::measurements
