// Lab 2 in the lecture's demo.

#include "measurements/support/demo.hpp"
#include "2-independent/experiments.hpp"
#include "checks/support/catch.hpp"

namespace mc::checks {

TEST_CASE("demo independent", "[.demo]") {
  DemoPoints points{.name = "independent", .is_sequence = true};
  points.points = [](std::uint64_t n, std::uint64_t sets,
                     std::uint64_t seed) -> std::optional<PointSets> {
    const std::vector<std::uint64_t> counts(sets, 2 * n);
    const auto got = TRY_MEASURE(uniforms, seed, counts, 0);
    const auto* const values = got ? got->if_exactly(2 * n * sets, unit) : nullptr;
    if (values == nullptr) return {};
    return PointSets{n, 2, *values};
  };
  write_demo("1-independent", points);
}

}  // namespace mc::checks
