// Lab 5 in the bench and in the demo: Halton and Sobol' points, shifted and scrambled.

#include "checks/support/catch.hpp"
#include "measurements/halton/methods.hpp"
#include "measurements/support/bench_data.hpp"
#include "measurements/support/demo.hpp"

namespace mc::measurements {
namespace {

std::vector<Method> benched() {
  return {shifted(method(methods, "halton")), method(methods, "scrambled_halton"),
          shifted(method(methods, "sobol")), method(methods, "scrambled_sobol")};
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

/// Randomized, since an RMSE is shown next to an error. As in lab 6: base 2 by 5.8, whose errors
/// fall faster than those of 5.9, base 3 by 5.9.
TEST_CASE("demo", "[.demo]") {
  Method halton = method(methods, "scrambled_halton");
  halton.is_sequence = true;
  halton.points = [](Count n, Count, Count count, Count seed) {
    const Sets base_2 = sets_of(TRY_MEASURE(radical_inverses, 2, 0, n), n, 1, 1);
    if (base_2.empty()) return Sets{};
    return sets_by_columns(n, 2, count, seed, [&](unsigned d, const Seeds& seeds) {
      const auto column = base_2[0].column(0);
      return d == 0 ? TRY_MEASURE(owen_scramble, {column.begin(), column.end()}, seeds)
                    : TRY_MEASURE(radical_inverses_scrambled, 3, 0, n, seeds);
    });
  };
  write_demo(5, halton);
  write_demo(6, method(methods, "scrambled_sobol"));
}

}  // namespace
}  // namespace mc::measurements
