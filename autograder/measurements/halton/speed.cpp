// Lab 5: how fast the speed tasks are, shown beside a verdict.

#include "checks/support/catch.hpp"
#include "measurements/halton/bench_samplers.hpp"
#include "measurements/halton/timed.hpp"

namespace mc::checks {
namespace {

TEST_CASE("speed of sequences", "[.speed]") {
  const auto column = [](unsigned task, unsigned of) {
    return [=](std::uint64_t rounds) { return seconds_of_columns(task, of, 4096, rounds); };
  };
  bench_speed("5.2", "radical inverses in base 3", 4096, column(2, 3));
  bench_speed("5.5", "Sobol' coordinates", 4096, column(5, 1));
  bench_speed("5.8", "scrambled Sobol' coordinates", 4096, column(8, 1));
  bench_speed_error("5.8", "scrambled Sobol' coordinates", bench_sampler(8, ""), 1024);
}

}  // namespace
}  // namespace mc::checks
