// Lab 4 in the bench: best candidates and Poisson disks.

#include <cmath>

#include "4-blue-noise/experiments.hpp"
#include "checks/support/bench_data.hpp"
#include "checks/support/catch.hpp"

namespace mc::checks {
namespace {

/// About 0.7 / radius^2 points are a pattern: a radius for n of them.
double radius_for(std::uint64_t n) {
  return std::sqrt(0.7 / static_cast<double>(n));
}

std::vector<BenchSampler> samplers() {
  const auto way = [](unsigned task, std::string name, std::uint64_t most) {
    BenchSampler made{std::move(name), {2}, most};
    made.rounds = [=](std::uint64_t n, std::uint64_t, std::uint64_t rounds) {
      return cpu_seconds_of(TRY_MEASURE_WITH(large, repeat, task, n, rounds));
    };
    return made;
  };
  // Best candidates take a time that grows as n^2: 400 sets of 1,024 are enough to wait for.
  BenchSampler candidates = way(2, "best candidate", 1024), discs = way(3, "Poisson disk", 16384);
  candidates.points = [](std::uint64_t n, std::uint64_t, std::uint64_t sets,
                         std::uint64_t seed) -> std::optional<PointSets> {
    const auto got = TRY_MEASURE_WITH(large, best_candidate, n, 1, sets, seed);
    if (!got) return {};
    PointSets all{n, 2, {}};
    for (std::size_t first = 0; first < got->value.x.size(); first += n) {
      const auto at = static_cast<std::ptrdiff_t>(first),
                 end = static_cast<std::ptrdiff_t>(first + n);
      for (const auto* column : {&got->value.x, &got->value.y}) {
        all.values.insert(all.values.end(), column->begin() + at, column->begin() + end);
      }
    }
    return all;
  };
  return {candidates, discs};
}

/// Poisson disks come in sets of different sizes, so each is an error of its own.
TEST_CASE("bench error", "[.bench-error]") {
  auto all = samplers();
  const BenchSampler discs = all.back();
  all.pop_back();
  bench_errors(all);
  for (const std::uint64_t n : bench_sizes(discs, 2)) {
    const std::uint64_t sets = n <= 1024 ? 400 : 64;
    const auto got = TRY_MEASURE_WITH(large, poisson_disk, radius_for(n), sets, n);
    if (!got) return;
    bench_errors_of_sets("Poisson disk", got->value.sizes, got->value.x, got->value.y);
  }
}
TEST_CASE("bench time", "[.bench-time]") {
  bench_times(samplers());
}
TEST_CASE("bench growth", "[.bench-growth]") {
  const auto grow = [](const char* name, unsigned task, std::uint64_t most) {
    bench_growth(
        name, 2, most,
        [=](std::uint64_t n, std::uint64_t rounds) {
          return used_by(TRY_MEASURE_WITH(large, repeat, task, n, rounds));
        },
        256, 4);
  };
  grow("best candidate", 2, 4096);
  grow("Poisson disk", 3, 65536);
}

TEST_CASE("speed of blue noise", "[.speed]") {
  const BenchSampler candidates = samplers()[0], discs = samplers()[1];
  bench_speed("4.7", "best candidates", 256,
              [&](std::uint64_t rounds) { return candidates.rounds(256, 2, rounds); });
  bench_speed_error("4.7", "best candidates", candidates, 256);
  bench_speed("4.7", "Poisson disks", 1024,
              [&](std::uint64_t rounds) { return discs.rounds(1024, 2, rounds); });
}

}  // namespace
}  // namespace mc::checks
