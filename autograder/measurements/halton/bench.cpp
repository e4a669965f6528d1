// Lab 5 in the bench: Halton and Sobol' points, shifted and scrambled.

#include "checks/support/catch.hpp"
#include "measurements/halton/methods.hpp"
#include "measurements/support/bench_data.hpp"

namespace mc::measurements {
namespace {

std::vector<Method> benched() {
  return {shifted(method(methods, "halton")), method(methods, "scrambled_halton"),
          shifted(method(methods, "sobol")), method(methods, "scrambled_sobol"),
          method(methods, "lattice")};
}

TEST_CASE("bench error", "[.bench-error]") {
  bench_errors(benched());
}
TEST_CASE("bench time", "[.bench-time]") {
  bench_times(benched());
}
TEST_CASE("bench growth", "[.bench-growth]") {
  for (const Method& one : benched()) bench_growth_of_dims(one.name, one);
  // Columns of one axis, which are not cut into blocks.
  for (const auto& [name, task, of] : {std::tuple{"5.2 radical inverses, base 3", 2u, 3u},
                                       {"5.5 Sobol', dimension 1", 5u, 1u},
                                       {"5.8 the same, scrambled", 8u, 1u},
                                       {"5.9 scrambled radical inverses, base 3", 9u, 3u}}) {
    bench_growth(name, 1, 100'000'000, [task = task, of = of](Count n, Count rounds) {
      return used_by(TRY_MEASURE_WITH(large, repeat, task, of, n, rounds, 1));
    });
  }
}

}  // namespace
}  // namespace mc::measurements
