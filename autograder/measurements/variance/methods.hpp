#pragma once
// Lab 1's ways to a variance.

#include <random>

#include "1-variance/experiments.hpp"
#include "checks/support/compare.hpp"
#include "checks/support/exact.hpp"
#include "checks/variance/data_sets.hpp"
#include "measurements/support/methods.hpp"

namespace mc::measurements {

inline unsigned task_of(const Method& way) {
  return static_cast<unsigned>(way.task.back() - '0');
}

inline const Methods methods = [] {
  Methods all{{"textbook_formula", "1.2", "textbook"},
              {"two_passes", "1.3", "two passes"},
              {"welford", "1.4", "Welford"},
              {"merged", "1.5", "merged parts"},
              {"fast_moments", "1.8", "moments"}};
  for (Method& way : all) way.rounds = ROUNDS_BY(repeat_made, task_of(way), n, rounds, 1);
  return all;
}();

/// The variances of each `size` values of x; none where the way is not written.
inline Values variances_by(const Method& way, const Values& x, std::size_t size) {
  return values_of(TRY_MEASURE(variances, task_of(way), x, size), x.size() / size, any_number);
}
inline double exact_variance(const Values& x, std::size_t first, std::size_t size) {
  return exact_moments(std::span(x).subspan(first, size)).variance;
}

/// The correct digits of these variances, 16 at most.
inline Values digits_kept(const Method& way, const Values& x, std::size_t size) {
  Values kept;
  for (const double found : variances_by(way, x, size)) {
    const double exact = exact_variance(x, kept.size() * size, size);
    kept.push_back(std::clamp(digits(found, exact), 0.0, 16.0));
  }
  return kept;
}

/// Moments of 4,096 values by 1.`task`: 32 KB, in the first-level cache.
inline Rounds moments_by(unsigned task) {
  return [=](Count rounds) {
    static Rng rng{std::random_device()()};
    static const Values x = uniform_values(rng, 4096, 1e6, 1e6 + 1);
    return TRY_MEASURE(repeat, task, x, rounds, 1);
  };
}

inline const std::vector<SpeedTask> speed_tasks{
    {"1.8", "moments", 4096, moments_by(8), {}, 0, moments_by(4)}};

}  // namespace mc::measurements
