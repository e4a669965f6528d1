#pragma once
// What the random checks of this lab share. What is random about the randomised points is tested
// against distributions that are exact; each test has the same alpha, and there are about thirty.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "checks/support/statistics.hpp"
#include "common/rng.hpp"

namespace mc::checks {

inline constexpr double one_alpha = 1e-8;

inline double uniform_cdf(double x) {
  return std::clamp(x, 0.0, 1.0);
}

/// On the circle of length 1.
inline double wrapped(double x) {
  return x - std::floor(x);
}

inline std::vector<std::uint64_t> fresh_seeds(Rng& rng, std::size_t count) {
  std::vector<std::uint64_t> seeds(count);
  for (auto& seed : seeds) seed = rng();
  return seeds;
}

/// `pairs` of numbers in [0, 1), the second behind the first, fill 8 x 8 cells evenly. Wants about
/// 6,400 of them. That sees, for example, a second number that is a multiple of the first.
inline void expect_even_pairs(const std::string& what, std::span<const double> pairs,
                              const Null& null, const Hints& hints) {
  std::vector<std::uint64_t> counts(64);
  for (std::size_t i = 0; i + 1 < pairs.size(); i += 2) {
    ++counts[static_cast<std::size_t>(pairs[i] * 8) * 8 +
             static_cast<std::size_t>(pairs[i + 1] * 8)];
  }
  const double one_of_all = 1. / 64;
  expect_counts(what + ", in 8 x 8 cells", counts, std::span(&one_of_all, 1), null, hints);
}

}  // namespace mc::checks
