#pragma once
// Lab 2 timed, and what it gave judged.

#include "2-independent/experiments.hpp"
#include "measurements/support/plot_data.hpp"
#include "measurements/support/speed_data.hpp"

namespace mc::checks {

/// CPU time of calls of 2.8 for n numbers: each gave what it gives in a process of its own.
inline std::optional<double> seconds_of_uniforms(std::uint64_t n, std::uint64_t rounds,
                                                 const sandbox::Limits& limits = {}) {
  const ShownRounds some = shown_rounds(rounds, n);
  const auto timed = TRY_MEASURE_WITH(limits, repeat_source, 2, n, rounds, some.seed, some.shown);
  const auto judged = TRY_MEASURE(uniforms_in_turn, some.seeds, n);
  if (!timed || !judged) return {};
  const std::size_t count = n * some.seeds.size();
  const auto* const numbers = judged->if_exactly(count, unit);
  if (numbers == nullptr) return {};
  expect_as_judged(some, timed->if_exactly(count, unit), *numbers);
  return timed->cpu_seconds;
}

}  // namespace mc::checks
