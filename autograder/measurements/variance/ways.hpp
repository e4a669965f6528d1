#pragma once
// Lab 1's ways to a variance, which plots and bench read.

#include "1-variance/experiments.hpp"
#include "checks/support/compare.hpp"
#include "checks/support/exact.hpp"
#include "checks/variance/data_sets.hpp"
#include "measurements/support/methods.hpp"
#include "measurements/support/speed_data.hpp"

namespace mc::measurements {

inline const std::vector<Method> ways{{"textbook_formula", "1.2", "textbook"},
                                      {"two_passes", "1.3", "two passes"},
                                      {"welford", "1.4", "Welford"},
                                      {"merged", "1.5", "merged parts"},
                                      {"fast_moments", "1.8", "moments"}};
inline unsigned task_of(const Method& way) {
  return static_cast<unsigned>(way.task.back() - '0');
}

/// The digits that a way keeps of the variance of each `size` values of x, 16 at most; none where
/// it is not written.
inline std::vector<double> digits_kept(const Method& way, const Values& x, std::size_t size) {
  const auto found =
      lists_of(TRY_MEASURE(variances, task_of(way), x, size), x.size() / size, any_number);
  std::vector<double> kept;
  for (std::size_t i = 0; found && i < found->size(); ++i) {
    const double exact = exact_moments(std::span(x).subspan(i * size, size)).variance;
    kept.push_back(std::clamp(digits((*found)[i], exact), 0.0, 16.0));
  }
  return kept;
}

/// Nanoseconds per value of a way over x.
inline Number nanoseconds_of(const Method& way, const Values& x) {
  const Number round = seconds_of(
      [&](std::uint64_t rounds) {
        return cpu_seconds_of(TRY_MEASURE(repeat, task_of(way), x, rounds, 1));
      },
      0.025, 3);
  if (!round) return {};
  return *round * 1e9 / static_cast<double>(x.size());
}

}  // namespace mc::measurements
