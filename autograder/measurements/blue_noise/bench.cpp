// Lab 4 in the bench: best candidates and Poisson disks.

#include "checks/support/catch.hpp"
#include "measurements/blue_noise/methods.hpp"
#include "measurements/support/bench_data.hpp"

namespace mc::measurements {
namespace {

std::vector<Method> benched() {
  return methods_of(methods, {"best_candidate", "poisson_disk"});
}

TEST_CASE("bench error", "[.bench-error]") {
  bench_errors(benched());
}
TEST_CASE("bench time", "[.bench-time]") {
  bench_times(benched());
}
TEST_CASE("bench growth", "[.bench-growth]") {
  const auto grow = [](const char* name, unsigned task, std::uint64_t most) {
    bench_growth(
        name, 2, most,
        [=](std::uint64_t n, std::uint64_t rounds) {
          return used_by(TRY_MEASURE_WITH(large, repeat, task, n, rounds, 1));
        },
        256, 4);
  };
  grow("best candidate", 2, 4096);
  grow("Poisson disk", 3, 65536);
}

}  // namespace
}  // namespace mc::measurements
