#pragma once
// Lab 5's methods of making points.

#include "5-halton/experiments.hpp"
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
    return TRY_MEASURE(radical_inverse, bases[d], domain::in_a_row(0, n));
  });
}
inline Sets scrambled_halton_sets(Count n, const std::vector<unsigned>& bases, Count count,
                                  Count seed) {
  return sets_by_columns(n, bases.size(), count, seed, [&](unsigned d, const Seeds& seeds) {
    return TRY_MEASURE(radical_inverses_scrambled, bases[d], 0, n, seeds);
  });
}

inline Sets rotated(const Sets& one, Count count, Count seed) {
  if (one.empty()) return {};
  const Count n = one[0].size(), dims = one[0].dims();
  Values all;
  for (Count d = 0; d < dims; ++d) append(all, one[0].column(d));
  return sets_of(TRY_MEASURE(random_shift, all, dims, count, seed), n, dims, count);
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

/// A method that fails, to compare with: base 2 scrambled by a hash of all bits at once that is
/// right for pairs of points only, for its one multiplication by a random number is followed by one
/// mixing step.
inline Sets hashed_points(Count n, Count, Count count, Count seed) {
  Sets sets(count, PointSet(n, 1));
  for (PointSet& set : sets) {
    Rng rng(seed++);
    const Count shift = rng(), factor = rng() | 1;
    for (Count i = 0; i < n; ++i) {
      Count z = i;  // its radical inverse has these bits, the first one lowest
      z ^= z << 5;
      z = z * factor + shift;
      z ^= z * 0xb82f1e52d1342544u;
      Count reversed = 0;
      for (int bit = 0; bit < 53; ++bit) reversed = reversed << 1 | (z >> bit & 1);
      set.column(0)[i] = static_cast<double>(reversed) * 0x1p-53;
    }
  }
  return sets;
}

inline const Methods methods = [] {
  const auto repeated = [](unsigned task) {
    return ROUNDS_BY(repeat_points, task, n, dims, rounds);
  };
  const std::vector<Count> all_dims{1, 2, 4, 8};
  const Traits one_set{.is_random = false};
  const MakePoints halton = POINTS_BY(halton, n, dims, 0);
  const auto one_by_one = [](Count n, Count dims, Count rounds, const sandbox::Limits& limits) {
    double seconds = 0;
    for (const unsigned base : first_primes(dims)) {
      seconds += Cost(TRY_MEASURE_WITH(limits, repeat, 1, base, n, rounds, 1)).seconds;
    }
    return Cost(seconds);
  };
  const auto scrambled_halton = [](Count n, Count dims, Count count, Count seed) {
    return scrambled_halton_sets(n, first_primes(dims), count, seed);
  };
  const auto sobol = [](Count n, Count dims, Count, Count) { return sobol_sets(n, dims); };
  const auto scrambled_sobol = [](Count n, Count dims, Count count, Count seed) {
    return scrambled(sobol_sets(n, dims), count, seed);
  };
  const auto rotated_base_2 = [](Count n, Count, Count count, Count seed) {
    return rotated(halton_sets(n, {2}), count, seed);
  };
  const auto folded = [](Count n, Count dims, Count count, Count seed) {
    const Values points = lattice_points(n, dims, count, seed);
    return points.empty() ? Sets{} : sets_of(TRY_MEASURE(tent, points), n, dims, count);
  };
  return Methods{independent_points,
                 jittered_points,
                 {"radical_inverse", "5.1", "Halton", halton, one_by_one, one_set},
                 {"halton", "5.3", "Halton", halton, repeated(3), in_bench(all_dims, one_set)},
                 {"scrambled_halton", "5.9", "Halton, scrambled", scrambled_halton, repeated(9),
                  in_bench(all_dims)},
                 {"hammersley", "5.4", "Hammersley", POINTS_BY(hammersley, n, dims), {}, one_set},
                 {"sobol", "5.5", "Sobol'", sobol, repeated(5), in_bench(all_dims, one_set)},
                 {"scrambled_sobol", "5.8", "Sobol', scrambled", scrambled_sobol, repeated(8),
                  in_bench(all_dims)},
                 {"rotated", "5.7", "Cranley-Patterson rotation", rotated_base_2},
                 {"lattice", "5.10", "lattice, folded", folded, repeated(10), in_bench(all_dims)},
                 {"hashed", "", "a hash that is right for pairs only", hashed_points}};
}();

/// Columns of one axis, not cut into blocks, by task 5.`task` in that base or dimension.
inline MakeRounds column_by(unsigned task, unsigned base_or_dimension) {
  return ROUNDS_BY(repeat, task, base_or_dimension, n, rounds, 1);
}
inline Rounds block_by(unsigned task, unsigned base_or_dimension) {
  return [=](Count rounds) { return column_by(task, base_or_dimension)(4096, 1, rounds, {}); };
}

inline Rounds plain_by(unsigned task) {
  return [=](Count rounds) { return TRY_MEASURE(repeat_plain, task, 4096, rounds); };
}

inline const std::vector<SpeedTask> speed_tasks{
    {"5.2", "radical inverses in base 3", 4096, block_by(2, 3), {}, 0, block_by(1, 3)},
    {"5.5", "Sobol' coordinates", 4096, block_by(5, 1), {}, 0, plain_by(5)},
    {"5.8", "scrambled Sobol' coordinates", 4096, block_by(8, 1), methods["scrambled_sobol"].points,
     1024, plain_by(8)}};

/// D* of the first set, by the submission.
inline double star_discrepancy_of(const Sets& sets) {
  if (sets.empty()) return missing;
  const auto x = sets[0].column(0), y = sets[0].column(1);
  const auto got = TRY_MEASURE(star_discrepancy_2d, {x.begin(), x.end()}, {y.begin(), y.end()});
  return got && got->value >= 0 && got->value <= 1 ? got->value : missing;
}

}  // namespace mc::measurements
