#pragma once
// Lab 1's ways to a variance.

#include "1-variance/experiments.hpp"
#include "checks/support/compare.hpp"
#include "checks/support/exact.hpp"
#include "checks/variance/data_sets.hpp"
#include "measurements/support/methods.hpp"

namespace mc::measurements {

inline unsigned task_of(const Method& way) {
  return static_cast<unsigned>(way.task.back() - '0');
}

inline const std::vector<Method> methods = [] {
  std::vector<Method> all{{"textbook_formula", "1.2", "textbook"},
                          {"two_passes", "1.3", "two passes"},
                          {"welford", "1.4", "Welford"},
                          {"merged", "1.5", "merged parts"},
                          {"fast_moments", "1.8", "moments"}};
  for (Method& way : all) way.rounds = ROUNDS_BY(repeat_made, task_of(way), n, rounds, 1);
  return all;
}();

/// Of a way over x.
inline Rounds rounds_over(const Values& x, unsigned task) {
  return [=](Count rounds) { return TRY_MEASURE(repeat, task, x, rounds, 1); };
}

/// The digits that a way keeps of the variance of each `size` values of x, 16 at most; none where
/// it is not written.
inline Values digits_kept(const Method& way, const Values& x, std::size_t size) {
  Values kept;
  for (const double found :
       values_of(TRY_MEASURE(variances, task_of(way), x, size), x.size() / size, any_number)) {
    const double exact = exact_moments(std::span(x).subspan(kept.size() * size, size)).variance;
    kept.push_back(std::clamp(digits(found, exact), 0.0, 16.0));
  }
  return kept;
}

}  // namespace mc::measurements
