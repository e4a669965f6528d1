#pragma once
// Fresh data for checks.

#include <vector>

#include "common/rng.hpp"

namespace mc::checks {

/// Uniform in [0, 1): 53 bits.
inline double uniform(Rng& rng) {
  return static_cast<double>(rng() >> 11) * 0x1p-53;
}

/// Uniform in [low, high).
inline double uniform(Rng& rng, double low, double high) {
  return low + (high - low) * uniform(rng);
}

inline std::vector<double> uniform_values(Rng& rng, std::size_t n, double low, double high) {
  std::vector<double> x(n);
  for (double& value : x) value = uniform(rng, low, high);
  return x;
}

}  // namespace mc::checks
