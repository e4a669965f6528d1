#pragma once
// Lab 5 timed, and what it gave judged: column by column of the rounds that are shown.

#include <cmath>
#include <optional>

#include <fmt/format.h>

#include "5-halton/experiments.hpp"
#include "checks/halton/exact_inverses.hpp"
#include "checks/halton/measured_columns.hpp"
#include "checks/halton/sobol_points.hpp"
#include "checks/support/speed_data.hpp"

namespace mc::checks {

/// Where the round of that seed begins, as repeat() has it.
inline std::uint64_t first_of(std::uint64_t seed) {
  return 4096 * (seed % 4096);
}

/// The radical inverse of an index below 2^32 in a base up to 2^16: both whole numbers stay below 2^53,
/// and one division rounds.
inline double short_inverse(unsigned base, std::uint64_t index) {
  double mirrored = 0, size = 1;
  for (; index > 0; index /= base, size *= base) {
    mirrored = mirrored * base + static_cast<double>(index % base);
  }
  return mirrored / size;
}

/// Column `first`, first + 1, … of 5.2 within its tolerance, and half a unit for our own rounding.
inline void expect_inverses(std::span<const double> got, unsigned base, std::uint64_t first) {
  for (std::size_t i = 0; i < got.size(); ++i) {
    const double exact = short_inverse(base, first + i);
    if (std::abs(got[i] - exact) <= inverse_tolerance + half_ulp) continue;
    throw WrongWhenTimed{fmt::format("{:.6g} for the radical inverse of {} in base {}, not {:.6g}",
                                     got[i], first + i, base, exact)};
  }
}

/// CPU time of columns of n values by task 5.`task`, 2, 5 or 8, in that base or dimension.
inline std::optional<double> seconds_of_columns(unsigned task, unsigned of, std::uint64_t n,
                                                std::uint64_t rounds) {
  const ShownRounds some = shown_rounds(rounds, n);
  const auto timed = TRY_MEASURE(repeat, task, of, n, rounds, some.seed, some.shown);
  if (!timed) return {};
  const auto* const all = timed->if_exactly(n * some.seeds.size(), unit);
  if (all == nullptr) throw WrongWhenTimed{"not as many numbers in [0, 1) as are due"};
  std::vector<double> right;
  for (std::size_t i = 0; i < some.seeds.size(); ++i) {
    const std::uint64_t first = first_of(some.seeds[i]);
    if (task == 2) {
      expect_inverses(std::span(*all).subspan(i * n, n), of, first);
      continue;
    }
    std::vector<double> column = sobol_points(of, first, n);
    if (task == 8) {
      const Column judged = column_of(TRY_MEASURE(owen_scramble, column, {some.seeds[i]}), n);
      if (!judged) return {};
      column = *judged;
    }
    right.insert(right.end(), column.begin(), column.end());
  }
  if (task != 2) expect_as_judged(some, all, right);
  return timed->cpu_seconds;
}

}  // namespace mc::checks
