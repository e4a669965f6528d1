// Lab 5 in the lecture's demo: randomised, since what is to be shown beside an error is an RMSE.

#include "measurements/support/demo.hpp"
#include "checks/support/catch.hpp"
#include "measurements/halton/bench_samplers.hpp"

namespace mc::checks {

TEST_CASE("demo Halton", "[.demo]") {
  DemoPoints points{.name = "Halton, scrambled", .is_sequence = true};
  points.points = [](std::uint64_t n, std::uint64_t sets, std::uint64_t seed) {
    // As in lab 6: base 2 by 5.8, whose errors fall faster than those of 5.9, base 3 by 5.9.
    return scrambled_sets(n, 2, sets, seed, [&](unsigned d, const auto& seeds) -> Column {
      const std::size_t count = n * seeds.size();
      if (d == 1) {
        return column_of(TRY_MEASURE(radical_inverses_scrambled, 3, 0, n, seeds), count);
      }
      const Column column = column_of(TRY_MEASURE(radical_inverses, 2, 0, n), n);
      if (!column) return {};
      return column_of(TRY_MEASURE(owen_scramble, *column, seeds), count);
    });
  };
  write_demo("5-halton", points);
}

TEST_CASE("demo Sobol'", "[.demo]") {
  DemoPoints points{.name = "Sobol', scrambled", .is_sequence = true};
  points.points = [](std::uint64_t n, std::uint64_t sets, std::uint64_t seed) {
    return bench_sampler(8, "").points(n, 2, sets, seed);
  };
  write_demo("6-sobol", points);
}

}  // namespace mc::checks
