// Lab 6: what a number costs, shown below a verdict.

#include "checks/support/catch.hpp"
#include "measurements/sampler/methods.hpp"
#include "measurements/support/speed_data.hpp"

namespace mc::measurements {

/// Four dimensions of a pixel with 16 samples, and with 64; of the required kinds.
TEST_CASE("speed of samplers", "[.speed]") {
  for (const Method& one : methods) {
    if (one.kind == "blue_noise" || one.kind == "lattice") continue;
    for (const Count n : {16u, 64u}) {
      bench_speed("6.8", fmt::format("a number, {}, {} samples", one.kind, n), 4 * n,
                  one.rounds_of(n, 4));
    }
  }
}

}  // namespace mc::measurements
