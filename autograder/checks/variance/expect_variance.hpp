#pragma once
// What several tasks are expected to do: keep the digits of a hard list, give up where there is no
// variance, count every value.

#include <functional>
#include <string>

#include "1-variance/experiments.hpp"
#include "data_sets.hpp"
#include "floors.hpp"
#include "suspects.hpp"

namespace mc::checks {

/// A variance, and how it was asked for.
struct Variance {
  double value;
  std::string call;
};

/// A way to the sample variance of a list.
struct Algorithm {
  std::function<Variance(const Values&)> variance;
  std::function<double(const ExactMoments&)> floor;
  std::string because;  ///< where the floor comes from
  std::function<Hints(double got, const Values&, const ExactMoments&, const std::string& otherwise)>
      hints;
  int outlier_lists = 1;  ///< of each kind
};

/// The hard cases that any sample variance of a list must get through, by whatever way: very large
/// and very small values, what has no finite variance, outliers, order.
void expect_hard_variance(Rng& rng, const Algorithm& by);

/// Not a finite number.
void expect_no_number(const std::string& call, double got, const Values& x);

void expect_moments(const std::string& call, const Moments& got, const ExactMoments& exact,
                    double mean_floor, double m2_floor, const std::string& because,
                    const Hints& mean_hints, const Hints& m2_hints);

/// Moments{}.
void expect_nothing(const std::string& call, const Moments& got, const std::string& because,
                    const std::string& hint);

}  // namespace mc::checks
