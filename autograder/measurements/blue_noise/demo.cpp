// Lab 4 in the lecture's demo.

#include "measurements/support/demo.hpp"
#include "checks/support/catch.hpp"
#include "measurements/blue_noise/bench_samplers.hpp"

namespace mc::checks {

TEST_CASE("demo blue noise", "[.demo]") {
  DemoPoints points{.name = "blue noise", .most = 1024};  // by the definition it takes N^3
  points.points = [](std::uint64_t n, std::uint64_t sets, std::uint64_t seed) {
    return blue_noise_samplers()[0].points(n, 2, sets, seed);
  };
  write_demo("4-blue-noise", points);
}

}  // namespace mc::checks
