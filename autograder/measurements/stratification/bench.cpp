// Lab 3 in the bench and in the demo: jittered points, padded ones, grids in all dimensions, Latin
// hypercubes.

#include "checks/support/catch.hpp"
#include "measurements/stratification/methods.hpp"
#include "measurements/support/bench_data.hpp"
#include "measurements/support/demo.hpp"

namespace mc::measurements {
namespace {

std::vector<Method> benched() {
  return methods_of(methods, {"stratified", "jittered", "padded", "jittered_nd", "latin_hypercube",
                              "multi_jittered"});
}

TEST_CASE("bench error", "[.bench-error]") {
  bench_errors(benched());
}
TEST_CASE("bench time", "[.bench-time]") {
  bench_times(benched());
}
TEST_CASE("bench growth", "[.bench-growth]") {
  for (const Method& one : methods_of(methods, {"padded", "latin_hypercube"})) {
    bench_growth_of_dims(one.name, one);
  }
  const auto grow = [](const char* name, unsigned task, std::uint64_t dims, std::uint64_t most) {
    bench_growth(name, dims, most, [=](std::uint64_t n, std::uint64_t rounds) {
      // A square number near it, where a square is wanted.
      const std::uint64_t size = task == 3 || task == 7 ? root(n, 2) * root(n, 2) : n;
      return used_by(TRY_MEASURE_WITH(large, repeat, task, size, dims, rounds, 1));
    });
  };
  grow("jittered", 1, 1, 100'000'000);
  grow("jittered", 3, 2, 10'000'000);
  grow("Latin hypercube", 6, 2, 10'000'000);
  grow("multi-jittered", 7, 2, 10'000'000);
}

TEST_CASE("demo", "[.demo]") {
  write_demo(2, method(methods, "jittered"));
  write_demo(3, method(methods, "multi_jittered"));
}

}  // namespace
}  // namespace mc::measurements
