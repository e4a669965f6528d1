#pragma once
// Lab 5's methods of making points.

#include "5-halton/experiments.hpp"
#include "measurements/support/integrands.hpp"
#include "measurements/support/methods.hpp"

namespace mc::measurements {

using Seeds = std::vector<Count>;

/// Sets whose columns come one by one: `make(d, seeds)` makes column d by each seed, one after the
/// other.
template <class Make>
Sets sets_by_columns(Count n, Count dims, Count count, Count seed, Make make) {
  Sets sets(count, PointSet(n, dims));
  for (Count d = 0; d < dims; ++d) {
    const Seeds seeds = domain::in_a_row((seed * 64 + d) << 20, count);
    const Sets columns = sets_of(make(static_cast<unsigned>(d), seeds), n, 1, count);
    if (columns.empty()) return {};
    for (Count set = 0; set < count; ++set) {
      std::copy_n(columns[set].column(0).begin(), n, sets[set].column(d).begin());
    }
  }
  return sets;
}

/// Dimensions `first`, first + 1, … of the Sobol' sequence; and scrambled by as many seeds.
inline Sets sobol_sets(Count n, Count dims, unsigned first = 0) {
  return sets_by_columns(
      n, dims, 1, 0, [&](unsigned d, const Seeds&) { return TRY_MEASURE(sobol, first + d, 0, n); });
}
inline Sets scrambled(const Sets& one, Count count, Count seed) {
  if (one.empty()) return {};
  return sets_by_columns(one[0].size(), one[0].dims(), count, seed,
                         [&](unsigned d, const Seeds& seeds) {
                           const auto column = one[0].column(d);
                           return TRY_MEASURE(owen_scramble, {column.begin(), column.end()}, seeds);
                         });
}

/// Radical inverses in these bases, plain and scrambled.
inline Sets halton_sets(Count n, const std::vector<unsigned>& bases) {
  return sets_by_columns(n, bases.size(), 1, 0, [&](unsigned d, const Seeds&) {
    return TRY_MEASURE(radical_inverses, bases[d], 0, n);
  });
}
inline Sets scrambled_halton_sets(Count n, const std::vector<unsigned>& bases, Count count,
                                  Count seed) {
  return sets_by_columns(n, bases.size(), count, seed, [&](unsigned d, const Seeds& seeds) {
    return TRY_MEASURE(radical_inverses_scrambled, bases[d], 0, n, seeds);
  });
}

inline std::vector<unsigned> first_primes(Count dims) {
  constexpr unsigned primes[] = {2, 3, 5, 7, 11, 13, 17, 19};
  return {primes, primes + dims};
}

/// Lattices, not folded: set after set.
inline Values lattice_points(Count n, Count dims, Count count, Count seed) {
  return values_of(TRY_MEASURE(lattice, n, dims, domain::in_a_row(seed << 20, count)),
                   n * dims * count, unit);
}

inline const std::vector<Method> methods = [] {
  const auto repeated = [](unsigned task) {
    return ROUNDS_BY(repeat_points, task, n, dims, rounds);
  };
  const std::vector<Count> in_bench{1, 2, 4, 8};
  return std::vector<Method>{
      independent_points(),
      jittered_points(),
      {.key = "radical_inverse",
       .task = "5.1",
       .name = "Halton",  // the same, one by one
       .points = POINTS_BY(halton, n, dims, 0),
       .rounds = [](Count n, Count dims, Count rounds, const sandbox::Limits& limits) -> Cost {
         double seconds = 0;
         for (const unsigned base : first_primes(dims)) {
           seconds += Cost(TRY_MEASURE_WITH(limits, repeat, 1, base, n, rounds, 1)).seconds;
         }
         return seconds;
       },
       .is_random = false},
      {.key = "halton",
       .task = "5.3",
       .name = "Halton",
       .points = POINTS_BY(halton, n, dims, 0),
       .rounds = repeated(3),
       .dims = in_bench,
       .is_random = false},
      {.key = "scrambled_halton",
       .task = "5.9",
       .name = "Halton, scrambled",
       .points =
           [](Count n, Count dims, Count count, Count seed) {
             return scrambled_halton_sets(n, first_primes(dims), count, seed);
           },
       .rounds = repeated(9),
       .dims = in_bench},
      {.key = "hammersley",
       .task = "5.4",
       .name = "Hammersley",
       .points = POINTS_BY(hammersley, n, dims),
       .is_random = false},
      {.key = "sobol",
       .task = "5.5",
       .name = "Sobol'",
       .points = [](Count n, Count dims, Count, Count) { return sobol_sets(n, dims); },
       .rounds = repeated(5),
       .dims = in_bench,
       .is_random = false},
      {.key = "scrambled_sobol",
       .task = "5.8",
       .name = "Sobol', scrambled",
       .points = [](Count n, Count dims, Count count,
                    Count seed) { return scrambled(sobol_sets(n, dims), count, seed); },
       .rounds = repeated(8),
       .dims = in_bench},
      // Any points of the line, rotated: those of base 2.
      {.key = "rotated",
       .task = "5.7",
       .name = "Cranley-Patterson rotation",
       .points =
           [](Count n, Count, Count count, Count seed) {
             const Values column = values_of(TRY_MEASURE(radical_inverses, 2, 0, n), n, unit);
             if (column.empty()) return Sets{};
             return sets_of(TRY_MEASURE(random_shift, column, 1, count, seed), n, 1, count);
           }},
      {.key = "lattice",
       .task = "5.10",
       .name = "lattice, folded",
       .points =
           [](Count n, Count dims, Count count, Count seed) {
             const Values points = lattice_points(n, dims, count, seed);
             if (points.empty()) return Sets{};
             return sets_of(TRY_MEASURE(tent, points), n, dims, count);
           },
       .rounds = repeated(10),
       .dims = in_bench}};
}();

/// A column of one axis, not cut into blocks, by task 5.`task` in that base or dimension.
inline Method column_of(std::string name, unsigned task, unsigned base_or_dimension) {
  return {.key = "",
          .task = "",
          .name = std::move(name),
          .rounds = ROUNDS_BY(repeat, task, base_or_dimension, n, rounds, 1)};
}

/// D* of the first set, by the submission.
inline double star_discrepancy_of(const Sets& sets) {
  if (sets.empty()) return missing;
  const auto x = sets[0].column(0), y = sets[0].column(1);
  const auto got = TRY_MEASURE(star_discrepancy_2d, {x.begin(), x.end()}, {y.begin(), y.end()});
  return got && got->value >= 0 && got->value <= 1 ? got->value : missing;
}

/// Of the mean of exp(x) over the first n points of base 2, scrambled by 5.8 in so many ways.
inline ErrorSums errors_of_exp(Count n, Count sets) {
  return errors_of(method(methods, "scrambled_sobol"), integrand("smooth 1D"), n, sets, n << 20);
}

}  // namespace mc::measurements
