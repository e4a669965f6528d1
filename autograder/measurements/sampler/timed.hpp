#pragma once
// Lab 6 timed.

#include "checks/sampler/samplers.hpp"
#include "measurements/support/plot_data.hpp"
#include "measurements/support/speed_data.hpp"

namespace mc::checks {

/// CPU time of `dims` coordinates by next2() for each of n samples.
inline std::optional<double> seconds_of_samples(const std::string& kind, std::uint64_t dims,
                                                std::uint64_t n, std::uint64_t rounds) {
  return cpu_seconds_of(TRY_MEASURE(repeat, kind, 2, dims, n, rounds, 1));
}

}  // namespace mc::checks
