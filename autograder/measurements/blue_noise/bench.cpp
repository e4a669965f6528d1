// Lab 4 in the bench: best candidates and Poisson disks.

#include "checks/support/catch.hpp"
#include "measurements/blue_noise/bench_samplers.hpp"

namespace mc::checks {

/// Poisson disks come in sets of different sizes, so each is an error of its own.
TEST_CASE("bench error", "[.bench-error]") {
  auto all = blue_noise_samplers();
  const BenchSampler discs = all.back();
  all.pop_back();
  bench_errors(all);
  for (const std::uint64_t n : bench_sizes(discs, 2)) {
    const std::uint64_t sets = n <= 1024 ? 400 : 64;
    const double radius = radius_for(static_cast<double>(n));
    const auto got = TRY_MEASURE_WITH(large, poisson_disk, radius, sets, n);
    if (!got || patterns_if_any(*got, radius, sets).empty()) return;
    const auto [x, y, sizes] = patterns_due(radius, sets);
    const auto* const points = got->if_list_by_list({x, y, sizes});
    bench_errors_of_sets("Poisson disk", points->sizes, points->x, points->y);
  }
}
TEST_CASE("bench time", "[.bench-time]") {
  bench_times(blue_noise_samplers());
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

}  // namespace mc::checks
