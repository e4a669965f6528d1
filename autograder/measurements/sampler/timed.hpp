#pragma once
// Lab 6 timed, and what it gave judged.

#include <bit>

#include "checks/sampler/samplers.hpp"
#include "checks/support/strata.hpp"
#include "measurements/support/plot_data.hpp"
#include "measurements/support/speed_data.hpp"

namespace mc::checks {

/// One of N numbers in each of N strata?
inline bool is_one_in_each(View x) {
  std::vector<bool> seen(x.size());
  for (const double value : x) {
    const auto stratum = stratum_of(value, x.size());
    if (!stratum || seen[*stratum]) return false;
    seen[*stratum] = true;
  }
  return true;
}

/// CPU time of `dims` coordinates by next2() for each of n samples: the sum of a round is that of
/// the numbers that another sampler of its seed hands out, added in the same order.
inline std::optional<double> seconds_of_samples(const std::string& kind, std::uint64_t dims,
                                                std::uint64_t n, std::uint64_t rounds) {
  const std::uint64_t uses = (dims + 1) / 2;
  const ShownRounds some = shown_rounds(rounds, 2 * uses * n);
  const auto timed = TRY_MEASURE(repeat, kind, 2, dims, n, rounds, some.seed, some.shown);
  const auto judged = TRY_MEASURE(columns, kind, n, some.seeds, Uses(uses, 2));
  if (!timed || !judged) return {};
  const auto* const numbers = judged->if_exactly(some.seeds.size() * 2 * uses * n, unit);
  if (numbers == nullptr) return {};
  // Whoever knows the number of samples by sight is not seen by comparing.
  const bool are_strata =
      kind == "stratified" || (kind == "sobol" && std::has_single_bit(n) && uses <= 4);
  Values sums;
  const SetsOfPoints sets(*numbers, n, 2 * uses);
  for (std::size_t set = 0; set < sets.size(); ++set) {
    for (std::size_t d = 0; d < 2 * uses && are_strata; ++d) {
      if (is_one_in_each(sets.column(set, d))) continue;
      throw WrongWhenTimed{fmt::format("not one number in each of {} strata", n)};
    }
    double sum = 0;
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t d = 0; d < 2 * uses; d += 2) {
        sum += sets.column(set, d)[i] + sets.column(set, d + 1)[i];
      }
    }
    sums.push_back(sum);
  }
  expect_as_judged(some, timed->if_exactly(sums.size()), sums);
  return timed->cpu_seconds;
}

/// CPU time of integrals of a scene, each what a sampler of its own gives for its seed.
inline std::optional<double> seconds_of_integrals(const std::string& kind, const std::string& scene,
                                                  std::uint64_t n, std::uint64_t rounds) {
  const ShownRounds some = shown_rounds(rounds, 1);
  const auto timed = TRY_MEASURE(repeat_scene, kind, scene, n, rounds, some.seed, some.shown);
  const auto judged = TRY_MEASURE(estimates, kind, scene, {}, 1, 0, n, some.seeds);
  if (!timed || !judged) return {};
  const auto* const integrals = judged->if_exactly(some.seeds.size());
  if (integrals == nullptr) return {};
  expect_as_judged(some, timed->if_exactly(integrals->size()), *integrals);
  return timed->cpu_seconds;
}

}  // namespace mc::checks
