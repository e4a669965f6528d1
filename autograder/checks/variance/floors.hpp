#pragma once
// How many digits a right algorithm keeps. Every exact value is computed here, in 106 bits, from
// the very doubles that were sent. Floors come from two bounds (Chan, Golub, LeVeque 1983, table
// 2), with a digit of room for their constants:
//
//   n eps          what n additions may lose in any order       two passes, shifted, in blocks
//   n kappa eps    what a mean rounded n times may lose,        one pass (Welford, merging)
//                  kappa = sqrt(1 + mean^2 / variance)
//
// Roundings that scatter lose sqrt(n) where these bounds say n: the algorithms themselves are
// measured one to three digits above their floors.

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "checks/support/exact.hpp"

namespace mc::checks {

inline constexpr double eps = std::numeric_limits<double>::epsilon();
inline constexpr double room = 1;  // digits

inline double floor_of(double lost) {
  return std::min(16.0, -std::log10(lost)) - room;
}
inline double two_pass_floor(std::size_t n) {
  return floor_of(static_cast<double>(n) * eps);
}

/// Of a mean: n additions, or n roundings of a running mean, of values of this size.
inline double mean_tolerance(const ExactMoments& exact) {
  const double sigma = exact.count < 2 ? 0 : std::sqrt(exact.variance);
  return 10 * std::max(exact.count, 15.0) * eps *
         std::hypot(static_cast<double>(exact.mean), sigma);
}

inline double condition(const ExactMoments& exact) {
  const double mean = static_cast<double>(exact.mean);
  return std::sqrt(1 + mean * mean / exact.variance);
}
inline double one_pass_floor(const ExactMoments& exact) {
  return floor_of(exact.count * condition(exact) * eps);
}

/// Where values repeat, so do roundings: n of them lose n/4 eps then. A digit and a half of room,
/// as 1.8 promises.
inline double repeating_floor(double n) {
  return -std::log10(n / 4 * eps) - 1.5;
}

inline const std::string because_two_pass =
    "n additions lose at most n eps of the sum, in any order; one digit less is enough";
inline const std::string because_one_pass =
    "a running mean is rounded n times to eps |mean|, each of which costs the variance a fraction "
    "eps |mean| / sigma; one digit less is enough";
inline const std::string because_repeating =
    "n equal roundings lose n/4 eps; 1.5 digits less are enough";
inline const std::string because_undefined = "what is undefined is NaN, as in numpy and R";
inline const std::string stop_at_zero =
    "the correction is rounded, and may be larger than the sum: return 0 then";

}  // namespace mc::checks
