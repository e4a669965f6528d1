#pragma once
// Shared by the checks of lab 6. A sample dimension is a column of N numbers, and most properties
// are tested exactly: strata, digits of sequences, and equality with the numbers of a new sampler.
// Seeds and the parameters of scenes are random in each run. Bounds on random results without an
// alpha fail a correct answer with a total probability below 2e-7.

#include "6-sampler/experiments.hpp"
#include "checks/support/constructions.hpp"

namespace mc::checks {

using Uses = std::vector<unsigned>;  ///< 1 is next(), 2 is next2()

inline constexpr double alpha = 1e-8;
inline const std::array<std::string, 5> sampler_kinds{"independent", "stratified", "blue_noise",
                                                      "halton", "sobol"};

inline Uses repeated(std::size_t times, const Uses& some) {
  Uses uses;
  for (std::size_t i = 0; i < times; ++i) append(uses, some);
  return uses;
}

/// The numbers of a new sampler for each seed, one column per coordinate.
inline SampleSets columns_of(const std::string& kind, std::size_t n, const Seeds& seeds,
                             const Uses& uses) {
  std::size_t dims = 0;
  for (const unsigned use : uses) dims += use;
  const auto got = MEASURE(columns, kind, n, seeds, uses);
  return {got.call, seeds.size(), n, dims, got.exactly(seeds.size() * n * dims, unit)};
}

/// The coordinates of sample i, one replicate per seed.
inline SeededConstruction sample_of(const std::string& kind, std::size_t n, std::size_t i,
                                    const Uses& uses, const Randomness& claim) {
  return {claim, [=](const Seeds& seeds) {
            const SampleSets sets = columns_of(kind, n, seeds, uses);
            Uniforms numbers{sets.call, sets.dims};
            for (std::size_t set = 0; set < sets.size(); ++set) {
              for (std::size_t c = 0; c < sets.dims; ++c) {
                numbers.values.push_back(sets.column(set, c)[i]);
              }
            }
            numbers.name = [i](std::size_t c) {
              return fmt::format("coordinate {} of sample {}, over seeds", c, i);
            };
            return numbers;
          }};
}

/// The reason and the rule of a failure report.
struct Claim {
  std::string because, rule;
};

/// Coordinates c and c + 1 have one point in each cell of strata(N) and each stratum of both axes.
inline void expect_multi_jittered(const SampleSets& sets, std::size_t c) {
  const Grid grid = squarest(sets.n);
  expect_one_in_each_cell(sets, {{plane_of(grid, c)}},
                          "each cell (i, j) gets one point: a next2() is multi-jittered (3.7), in "
                          "blue_noise from the second on");
  expect_one_in_each_cell(sets, {{line_of(sets.n, c), line_of(sets.n, c + 1)}},
                          "multi-jittered points (3.7) also have one in each stratum of both axes");
}

inline const Likely numbers_repeat =
    "numbers repeat for another seed, dimension, coordinate or sample: make columns from a hash of "
    "the whole seed and the number of a dimension, not their sum; keep none in a "
    "static variable"_likely;

}  // namespace mc::checks
