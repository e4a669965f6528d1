#pragma once
// Lab 5 timed.

#include <optional>

#include "5-halton/experiments.hpp"
#include "measurements/halton/measured_columns.hpp"
#include "measurements/support/speed_data.hpp"

namespace mc::checks {

/// CPU time of columns of n values by task 5.`task`, in that base or dimension.
inline std::optional<double> seconds_of_columns(unsigned task, unsigned of, std::uint64_t n,
                                                std::uint64_t rounds) {
  return cpu_seconds_of(TRY_MEASURE(repeat, task, of, n, rounds, 1));
}

}  // namespace mc::checks
