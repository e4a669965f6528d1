#pragma once
// Lab 5's methods of making points.

#include "5-halton/experiments.hpp"
#include "measurements/support/integrands.hpp"
#include "measurements/support/methods.hpp"

namespace mc::measurements {

using Count = std::uint64_t;
using Seeds = std::vector<Count>;

/// Sets whose columns come one by one: `make(d, seeds)` makes column d by each seed, one after the
/// other.
template <class Make>
Sets sets_by_columns(Count n, Count dims, Count count, Count seed, Make make) {
  Sets sets(count, PointSet(n, dims));
  for (Count d = 0; d < dims; ++d) {
    Seeds seeds(count);
    std::iota(seeds.begin(), seeds.end(), (seed * 64 + d) << 20);
    const Sets columns = sets_of(make(static_cast<unsigned>(d), seeds), n, 1, count);
    if (columns.empty()) return {};
    for (Count set = 0; set < count; ++set) {
      std::copy_n(columns[set].column(0).begin(), n, sets[set].column(d).begin());
    }
  }
  return sets;
}

/// Columns of dimensions of the Sobol' sequence; and scrambled by as many seeds.
inline Sets sobol_sets(Count n, const std::vector<unsigned>& dimensions) {
  return sets_by_columns(n, dimensions.size(), 1, 0, [&](unsigned d, const Seeds&) {
    return TRY_MEASURE(sobol, dimensions[d], 0, n);
  });
}
inline Sets scrambled(const Sets& one, Count count, Count seed) {
  if (one.empty()) return {};
  return sets_by_columns(one[0].size(), one[0].dims(), count, seed,
                         [&](unsigned d, const Seeds& seeds) {
                           const auto column = one[0].column(d);
                           return TRY_MEASURE(owen_scramble, {column.begin(), column.end()}, seeds);
                         });
}

/// Lattices, not folded: set after set.
inline std::optional<std::vector<double>> lattice_points(Count n, Count dims, Count count,
                                                         Count seed) {
  return lists_of(TRY_MEASURE(lattice, n, dims, domain::in_a_row(seed << 20, count)),
                  n * dims * count, unit);
}

inline std::vector<unsigned> first_dimensions(Count dims) {
  std::vector<unsigned> all(dims);
  std::iota(all.begin(), all.end(), 0u);
  return all;
}

/// Deterministic points have an error, but no RMSE: for that they are shifted by random vectors,
/// here, so that it is done alike for all.
inline Method shifted(const Method& points) {
  Method moved = points;
  moved.is_random = true;
  moved.name += ", shifted";
  moved.points = [points](Count n, Count dims, Count count, Count seed) -> Sets {
    const Sets one = points.points(n, dims, 1, 1);
    if (one.empty()) return {};
    Sets sets(count, one[0]);
    Rng rng(seed);
    for (PointSet& set : sets) {
      for (Count d = 0; d < dims; ++d) {
        const double shift = uniform(rng);
        for (double& x : set.column(d)) x = x + shift < 1 ? x + shift : x + shift - 1;
      }
    }
    return sets;
  };
  return moved;
}

inline const std::vector<Method> methods = [] {
  constexpr static unsigned bases[] = {2, 3, 5, 7, 11, 13, 17, 19};
  const auto way = [](std::string key, unsigned task, std::string name, auto points) {
    return Method{.key = std::move(key),
                  .task = "5." + std::to_string(task),
                  .name = std::move(name),
                  .points = points,
                  .rounds =
                      [=](Count n, Count dims, Count rounds) {
                        return cpu_seconds_of(TRY_MEASURE(repeat_points, task, n, dims, rounds));
                      },
                  .dims = {1, 2, 4, 8}};
  };
  const auto halton_sets = [](Count n, Count dims, Count, Count) {
    return sets_of(TRY_MEASURE(halton, n, dims, 0), n, dims, 1);
  };
  std::vector<Method> all{
      independent_points(), jittered_points(),
      way("radical_inverse", 1, "Halton", halton_sets),  // the same, one by one
      way("halton", 3, "Halton", halton_sets),
      way("hammersley", 4, "Hammersley",
          [](Count n, Count dims, Count, Count) {
            return sets_of(TRY_MEASURE(hammersley, n, dims), n, dims, 1);
          }),
      way("sobol", 5, "Sobol'",
          [](Count n, Count dims, Count, Count) { return sobol_sets(n, first_dimensions(dims)); }),
      way("scrambled_sobol", 8, "Sobol', scrambled",
          [](Count n, Count dims, Count count, Count seed) {
            return scrambled(sobol_sets(n, first_dimensions(dims)), count, seed);
          }),
      way("scrambled_halton", 9, "Halton, scrambled",
          [](Count n, Count dims, Count count, Count seed) {
            return sets_by_columns(n, dims, count, seed, [&](unsigned d, const Seeds& seeds) {
              return TRY_MEASURE(radical_inverses_scrambled, bases[d], 0, n, seeds);
            });
          }),
      // Any points of the line, rotated: those of base 2.
      way("rotated", 7, "Cranley-Patterson rotation",
          [](Count n, Count, Count count, Count seed) {
            const auto column = lists_of(TRY_MEASURE(radical_inverses, 2, 0, n), n, unit);
            if (!column) return Sets{};
            return sets_of(TRY_MEASURE(random_shift, *column, 1, count, seed), n, 1, count);
          }),
      way("lattice", 10, "lattice, folded", [](Count n, Count dims, Count count, Count seed) {
        const auto points = lattice_points(n, dims, count, seed);
        return points ? sets_of(TRY_MEASURE(tent, *points), n, dims, count) : Sets{};
      })};
  for (const std::size_t i : {2u, 3u, 4u, 5u}) all[i].is_random = false;
  all[2].rounds = [](Count n, Count dims, Count rounds) -> Number {
    double seconds = 0;
    for (Count d = 0; d < dims; ++d) {
      const Number one = cpu_seconds_of(TRY_MEASURE(repeat, 1, bases[d], n, rounds, 1));
      if (!one) return {};
      seconds += *one;
    }
    return seconds;
  };
  all[6].is_sequence = true;
  return all;
}();

/// D* of the first set, by the submission.
inline Number star_discrepancy_of(const Sets& sets) {
  if (sets.empty()) return {};
  const auto x = sets[0].column(0), y = sets[0].column(1);
  const auto got = TRY_MEASURE(star_discrepancy_2d, {x.begin(), x.end()}, {y.begin(), y.end()});
  if (!got || !(got->value >= 0 && got->value <= 1)) return {};
  return got->value;
}

/// Of the mean of exp(x) over the first n points of base 2, scrambled by 5.8 in so many ways.
inline ErrorSums errors_of_exp(std::uint64_t n, std::uint64_t sets) {
  return errors_of(method(methods, "scrambled_sobol"), integrand("smooth 1D"), n, sets, n << 20);
}

}  // namespace mc::measurements
