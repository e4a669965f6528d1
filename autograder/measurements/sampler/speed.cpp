// Lab 6: what a number costs, shown below a verdict.

#include "checks/support/catch.hpp"
#include "measurements/sampler/methods.hpp"
#include "measurements/support/speed_data.hpp"

namespace mc::measurements {

/// Four dimensions of a pixel with 16 samples, and with 64.
TEST_CASE("speed of samplers", "[.speed]") {
  for (std::size_t k = 0; k < sampler_kinds.size(); ++k) {
    if (sampler_kinds[k] == "blue_noise")
      continue;  // its time grows with the square of the samples
    for (const std::uint64_t n : {16u, 64u}) {
      bench_speed("6.8", fmt::format("a number, {}, {} samples", sampler_kinds[k], n), 4 * n,
                  [&](std::uint64_t rounds) { return methods[k].rounds(n, 4, rounds); });
    }
  }
}

}  // namespace mc::measurements
