#pragma once
// What well-known mistakes give, and what to say to whoever made one.

#include <span>
#include <string>
#include <vector>

#include "checks/support/exact.hpp"
#include "checks/support/expect.hpp"

namespace mc::checks {

inline const std::string late_count =
    "the first value was divided by a count of 0: count it before";
inline const std::string empty_part = "0/0 is NaN: look for an empty part first";
inline const std::string large_numbers =
    "these are the digits that E{X^2} - E{X}^2 gives: two large numbers, nearly equal";
inline const std::string running_mean =
    "these are the digits of a running mean, rounded at every step: 1.4's";
inline const std::string uncorrected =
    "the mean was rounded: take (sum of deviations)^2 / n off the sum of squares";
inline const std::string stop_at_zero =
    "the correction is rounded, and may be larger than the sum: return 0 then";

/// Those suspects that the measured value is a hundred times nearer to than to the exact one. Where
/// a mistake costs a few digits only, its value and the right one are near each other, and near
/// many an innocent's.
std::vector<Suspect> nearest(double got, double exact, std::vector<Suspect> suspects);

/// The ways to get the scale of a variance wrong.
std::vector<Suspect> scale_suspects(const ExactMoments& exact);

/// For a variance of tame data.
Hints variance_hints(double got, std::span<const double> x, const ExactMoments& exact,
                     const std::string& otherwise);

/// For a variance of hard data: also other algorithms under this one's name. Says how many digits
/// the well-known ones keep of these data.
Hints hard_variance_hints(double got, std::span<const double> x, const ExactMoments& exact,
                          const std::string& otherwise);

/// For m2 by Welford's update, `divided` by something or by nothing.
Hints welford_hints(double got, std::span<const double> x, const ExactMoments& exact,
                    double divided, const std::string& otherwise);

/// `otherwise`, or where seven digits are left of data that cost a double three at most: a float?
std::string or_float(double got, double exact, const std::string& otherwise);

/// "; of these data E{X^2} - E{X}^2 keeps 0.3 digits, …"
std::string kept_by_known_ways(std::span<const double> x, const ExactMoments& exact);

}  // namespace mc::checks
