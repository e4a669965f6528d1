// Lab 6: what a number costs, shown beside a verdict.

#include "checks/support/catch.hpp"
#include "measurements/sampler/timed.hpp"

namespace mc::checks {
namespace {

/// Four dimensions of a pixel with 16 samples, and with 64.
TEST_CASE("speed of samplers", "[.speed]") {
  for (const std::string& kind : sampler_kinds) {
    if (kind == "blue_noise") continue;  // its time grows with the square of the samples
    for (const std::uint64_t n : {16u, 64u}) {
      bench_speed("6.8", fmt::format("a number, {}, {} samples", kind, n), 4 * n,
                  [&](std::uint64_t rounds) { return seconds_of_samples(kind, 4, n, rounds); });
    }
  }
}

}  // namespace
}  // namespace mc::checks
