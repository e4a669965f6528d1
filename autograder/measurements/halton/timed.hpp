#pragma once
// Lab 5 timed, and what it gave judged: column by column of the rounds that are shown.

#include <cmath>
#include <optional>
#include <random>

#include <fmt/format.h>

#include "5-halton/experiments.hpp"
#include "checks/halton/exact_inverses.hpp"
#include "checks/halton/sobol_points.hpp"
#include "measurements/halton/measured_columns.hpp"
#include "measurements/support/speed_data.hpp"

namespace mc::checks {

/// Where the round of that seed begins, as repeat() has it.
inline std::uint64_t first_of(std::uint64_t seed) {
  return 4096 * (seed % 4096);
}

/// The radical inverse of an index below 2^32 in a base up to 2^16: both whole numbers stay below
/// 2^53, and one division rounds.
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
    throw WrongWhenTimed{fmt::format("{:.6g} for index {} in base {}, of which 5.1 gives {:.6g}",
                                     got[i], first + i, base, exact)};
  }
}

/// Is `got` what 5.8 makes of a column with that seed? A hundred of its values, scrambled by
/// themselves, become the same: so nobody knows the column by its length. False where the program
/// does not say.
inline bool is_scrambled(std::span<const double> column, std::span<const double> got,
                         std::uint64_t seed) {
  constexpr std::size_t some = 100;
  static Rng places{std::random_device()()};
  std::vector<double> before, after;
  while (before.size() < some) {
    const std::size_t place = places() % column.size();
    before.push_back(column[place]);
    after.push_back(got[place]);
  }
  const Column judged = column_of(TRY_MEASURE(owen_scramble, before, {seed}), some);
  if (judged) expect_as_judged({seed, {0}, {seed}}, &after, *judged);
  return judged.has_value();
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
    const std::vector<double> column = sobol_points(of, first, n);
    if (task == 8 && !is_scrambled(column, std::span(*all).subspan(i * n, n), some.seeds[i])) {
      return {};
    }
    if (task == 5) right.insert(right.end(), column.begin(), column.end());
  }
  if (task == 5) expect_as_judged(some, all, right);
  return timed->cpu_seconds;
}

}  // namespace mc::checks
