// Lab 6 in the bench: scenes, through the interface of a sampler.

#include "checks/support/catch.hpp"
#include "measurements/sampler/methods.hpp"
#include "measurements/support/bench_data.hpp"

namespace mc::measurements {
namespace {

/// Calls run(kind, name, scene, n) for each kind on each scene at sizes 16, 16 factor, …, for as
/// long as it returns true; blue noise up to 256.
template <class Run>
void on_scenes(std::uint64_t factor, Run run) {
  for (const SceneRow& scene : scene_rows) {
    if (!scene.in_bench) continue;
    for (std::size_t k = 0; k < methods.size(); ++k) {
      const std::uint64_t most = kinds[k] == "blue_noise" ? 256 : methods[k].most;
      for (std::uint64_t n = 16; n <= most; n *= factor) {
        if (!run(kinds[k], methods[k].name, scene, n)) break;
      }
    }
  }
}

TEST_CASE("bench error", "[.bench-error]") {
  for (const SceneRow& scene : scene_rows) {
    const Known known = known_scene(scene.name, {});
    if (!scene.in_bench) continue;
    bench_row(
        {"variance", scene.name, "", scene.dims, 0, known.variance / (known.exact * known.exact)});
  }
  on_scenes(4, [](const auto& kind, const auto& name, const SceneRow& scene, std::uint64_t n) {
    bench_error(name, scene.name, scene.dims, n, scene_errors(kind, scene.name, n, 200, 1),
                known_scene(scene.name, {}).exact);
    return true;
  });
}

TEST_CASE("bench time", "[.bench-time]") {
  on_scenes(16, [](const auto& kind, const auto& name, const SceneRow& scene, std::uint64_t n) {
    return bench_time(name, scene.name, scene.dims, n, [&](std::uint64_t rounds) {
      return cpu_seconds_of(TRY_MEASURE(repeat_scene, kind, scene.name, n, rounds, 1));
    });
  });
}

TEST_CASE("bench growth", "[.bench-growth]") {
  for (std::size_t k = 0; k < methods.size(); ++k) {
    if (methods[k].most < 4096) continue;
    const std::string kind = kinds[k], name = "sampler: " + methods[k].name;
    Method by_next = methods[k];
    by_next.rounds = [=](std::uint64_t n, std::uint64_t dims, std::uint64_t rounds) {
      return cpu_seconds_of(TRY_MEASURE(repeat, kind, 1, dims, n, rounds, 1));
    };
    bench_growth_of_dims(name, by_next);
    bench_growth(name, 2, 10'000'000, [=](std::uint64_t n, std::uint64_t rounds) {
      return used_by(TRY_MEASURE_WITH(large, repeat, kind, 2, 2, n, rounds, 1));
    });
  }
}

}  // namespace
}  // namespace mc::measurements
