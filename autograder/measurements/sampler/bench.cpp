// Lab 6 in the bench: scenes, through the interface of a sampler.

#include <numeric>

#include "6-sampler/experiments.hpp"
#include "checks/sampler/samplers.hpp"
#include "checks/support/catch.hpp"
#include "checks/support/known_scenes.hpp"
#include "measurements/sampler/timed.hpp"
#include "measurements/support/bench_data.hpp"

namespace mc::checks {
namespace {

struct Benched {
  const char *kind, *name;
  std::uint64_t most;  ///< samples; the time of blue noise grows with their square
};
constexpr Benched benched[] = {{"independent", "independent", 16384},
                               {"stratified", "stratified", 16384},
                               {"blue_noise", "blue noise", 256},
                               {"halton", "Halton", 16384},
                               {"sobol", "Sobol'", 16384}};

/// From one next2() to next2(), next(), next2().
constexpr const char* benched_scenes[] = {"pixel_edge", "rect_light",   "penumbra_disk",
                                          "ao_sphere",  "defocus_edge", "pixel_time_lens"};

std::uint64_t dims_of_scene(const std::string& scene) {
  const auto got = TRY_MEASURE(uses_of, scene, {});
  const auto* const uses = got ? got->if_at_most(16, up_to(2)) : nullptr;
  return uses ? std::accumulate(uses->begin(), uses->end(), std::uint64_t{0}) : 0;
}

void bench_error(const Benched& kind, const std::string& scene, std::uint64_t n) {
  constexpr std::uint64_t replicates = 200;
  const auto got =
      TRY_MEASURE_WITH(large, estimates, kind.kind, scene, {}, 1, 0, n, neighbours(1, replicates));
  const Values* const estimates = got ? got->if_exactly(replicates) : nullptr;
  if (!estimates) return;
  const double exact = known_scene(scene, {}).exact;
  ErrorSums errors;
  for (const double value : *estimates) errors.add(value / exact - 1);
  bench_row(
      {"error", kind.name, scene, dims_of_scene(scene), n, errors.rmse(), errors.standard_error()});
}

TEST_CASE("bench error", "[.bench-error]") {
  for (const std::string scene : benched_scenes) {
    const Known known = known_scene(scene, {});
    bench_row({"variance", scene, "", dims_of_scene(scene), 0,
               known.variance / (known.exact * known.exact)});
    for (const Benched& kind : benched) {
      for (std::uint64_t n = 16; n <= kind.most; n *= 4) bench_error(kind, scene, n);
    }
  }
}

TEST_CASE("bench time", "[.bench-time]") {
  for (const std::string scene : benched_scenes) {
    for (const Benched& kind : benched) {
      for (std::uint64_t n = 16; n <= kind.most; n *= 16) {
        const auto round = seconds_once([&](std::uint64_t rounds) {
          return cpu_seconds_of(TRY_MEASURE(repeat_scene, kind.kind, scene, n, rounds, 1));
        });
        if (!round) break;
        bench_row({"time", kind.name, scene, dims_of_scene(scene), n,
                   *round * 1e9 / static_cast<double>(n)});
      }
    }
  }
}

TEST_CASE("bench growth", "[.bench-growth]") {
  for (const Benched& kind : benched) {
    if (kind.most < 4096) continue;
    const std::string name = std::string("sampler: ") + kind.name;
    BenchSampler sampler;
    sampler.name = name;
    sampler.rounds = [&](std::uint64_t n, std::uint64_t dims, std::uint64_t rounds) {
      return cpu_seconds_of(TRY_MEASURE(repeat, kind.kind, 1, dims, n, rounds, 1));
    };
    bench_growth_of_dims(sampler);
    bench_growth(name, 2, 10'000'000, [&](std::uint64_t n, std::uint64_t rounds) {
      return used_by(TRY_MEASURE_WITH(large, repeat, kind.kind, 2, 2, n, rounds, 1));
    });
  }
}

}  // namespace
}  // namespace mc::checks
