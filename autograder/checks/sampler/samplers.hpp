#pragma once
// What lab 6 measures: a sample dimension is a column of N numbers. So most of it is exact, for any
// right answer: strata are counted, digits are compared with those of the sequence, and the numbers
// of any calls with those of a new sampler. All seeds and the parameters of scenes are fresh in
// each run.
//
// Random tests have an alpha of 1e-8 each; there are fewer than eighty of them. A few more bounds
// hold with room to spare for whatever is right; each has the chance of failing a right answer next
// to it, and all of those together come to less than 2e-7.

#include "6-sampler/experiments.hpp"
#include "checks/support/checks.hpp"

namespace mc::checks {

using Uses = std::vector<unsigned>;  ///< 1 is next(), 2 is next2()
using Seeds = std::vector<std::uint64_t>;

inline constexpr double alpha = 1e-8;
inline const std::array<std::string, 5> sampler_kinds{"independent", "stratified", "blue_noise",
                                                      "halton", "sobol"};

inline Uses repeated(std::size_t times, const Uses& some) {
  Uses uses;
  for (std::size_t i = 0; i < times; ++i) uses.insert(uses.end(), some.begin(), some.end());
  return uses;
}

/// The numbers of a new sampler for each seed: a column for each coordinate.
inline SampleSets columns_of(const std::string& kind, std::size_t n, const Seeds& seeds,
                             const Uses& uses) {
  std::size_t dims = 0;
  for (const unsigned use : uses) dims += use;
  const auto got = MEASURE(columns, kind, n, seeds, uses);
  return {got.call, seeds.size(), n, dims, got.exactly(seeds.size() * n * dims, unit)};
}

/// The coordinates of one sample, a replicate for each seed.
inline Uniforms sample_of(const SampleSets& sets, std::size_t i) {
  Uniforms numbers{sets.call, sets.dims};
  for (std::size_t set = 0; set < sets.size(); ++set) {
    for (std::size_t c = 0; c < sets.dims; ++c) numbers.values.push_back(sets.column(set, c)[i]);
  }
  numbers.name = [i](std::size_t c) {
    return fmt::format("coordinate {} of sample {}, over seeds", c, i);
  };
  return numbers;
}

/// Why something is as it must be, and what is likely wrong where it is not.
struct Claim {
  std::string because, likely;
};

/// Coordinates c and c + 1 of all sets have one point in each cell of strata(N), and one in each of
/// N strata of either axis.
inline void expect_multi_jittered(const SampleSets& sets, std::size_t c) {
  const Grid grid = squarest(sets.n);
  for (std::size_t set = 0; set < sets.size(); ++set) {
    expect_one_in_each_cell(sets, set, plane_of(grid, c),
                            "each cell (i, j) gets one point, ((i + u) / nx, (j + v) / ny)");
    for (const std::size_t axis : {c, c + 1}) {
      expect_one_in_each_cell(sets, set, line_of(sets.n, axis),
                              "a jittered grid has one point in each cell; multi-jittered points "
                              "(3.7) have one in each stratum of either axis too");
    }
  }
}

/// Where all seeds, or several, have the same numbers: every seed got a new sampler.
inline const std::string same_for_seeds =
    "does this number depend on the seed at all? Anything static, or a column or a permutation "
    "that is kept, would not notice another seed";

}  // namespace mc::checks
