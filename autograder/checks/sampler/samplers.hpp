#pragma once
// What lab 6 checks. A use of a sampler is a column of N numbers, so most of it is exact, for any
// right answer: strata are counted, digits and bits are compared with those of the sequence, and
// the numbers of one walk through the samples with those of another. All seeds, sizes where they
// are free, and scenes' parameters are fresh in each run.
//
// Random tests have an alpha of 1e-8 each; there are fewer than seventy of them. Besides these a
// few bounds hold with room to spare for whatever is right; each has the chance of failing a right
// answer beside it, and all of those together come to less than 2e-7.

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "6-sampler/experiments.hpp"
#include "checks/support/battery.hpp"
#include "checks/support/data.hpp"
#include "checks/support/domain.hpp"
#include "checks/support/expect.hpp"

namespace mc::checks {

using Values = std::vector<double>;
using View = std::span<const double>;
using Uses = std::vector<unsigned>;  ///< 1 is next(), 2 is next2()
using Seeds = std::vector<std::uint64_t>;

inline constexpr double alpha = 1e-8;
inline const std::array<std::string, 5> sampler_kinds{"independent", "stratified", "blue_noise",
                                                      "halton", "sobol"};

inline bool is_sequence(const std::string& kind) {
  return kind == "halton" || kind == "sobol";
}

inline std::uint64_t fresh_seed(Rng& rng) {
  return rng() >> 32;  // short enough to be typed again
}

inline Seeds fresh_seeds(Rng& rng, std::size_t count) {
  Seeds seeds(count);
  for (auto& seed : seeds) seed = fresh_seed(rng);
  return seeds;
}

/// first, first + 1, …
inline Seeds neighbours(std::uint64_t first, std::size_t count) {
  Seeds seeds(count);
  for (std::size_t i = 0; i < count; ++i) seeds[i] = first + i;
  return seeds;
}

inline Uses repeated(std::size_t times, const Uses& some) {
  Uses uses;
  for (std::size_t i = 0; i < times; ++i) uses.insert(uses.end(), some.begin(), some.end());
  return uses;
}

inline std::size_t dims_of(const Uses& uses) {
  std::size_t dims = 0;
  for (const unsigned use : uses) dims += use;
  return dims;
}

/// What samplers of a kind hand out, one for each seed: N numbers in [0,1) for each coordinate.
struct Columns {
  std::string call;
  std::size_t n, dims;
  Values all;

  std::size_t sets() const { return all.size() / (n * dims); }
  View operator()(std::size_t set, std::size_t c) const {
    return View(all).subspan((set * dims + c) * n, n);
  }
  View operator[](std::size_t c) const { return (*this)(0, c); }

  /// The coordinates of the first sample, a replicate for each seed.
  Uniforms first_samples() const {
    Uniforms numbers{call, dims};
    for (std::size_t set = 0; set < sets(); ++set) {
      for (std::size_t c = 0; c < dims; ++c) numbers.values.push_back((*this)(set, c)[0]);
    }
    numbers.name = [](std::size_t c) {
      return fmt::format("coordinate {} of the first sample, over seeds", c);
    };
    return numbers;
  }
};

inline Columns columns_of(const std::string& kind, std::size_t n, const Seeds& seeds,
                          const Uses& uses) {
  const auto got = MEASURE(columns, kind, n, seeds, uses);
  const std::size_t dims = dims_of(uses);
  return {got.call, n, dims, got.exactly(seeds.size() * n * dims, unit)};
}

/// What to suspect where all seeds, or several, have the same numbers: every seed got a new
/// sampler.
inline const std::string same_for_seeds =
    "does the seed of generate() decide about it? Anything static, or a column or a permutation "
    "kept "
    "from before, would not notice another seed";

}  // namespace mc::checks
