#pragma once
// What the variances are taken of. All of it is fresh in each run.

#include <initializer_list>
#include <span>
#include <utility>
#include <vector>

#include "checks/support/data.hpp"
#include "checks/support/exact.hpp"

namespace mc::checks {

using Values = std::vector<double>;

/// Uniform values of which the first two lie in the first and in the last quarter, so that the
/// variance of two or three is never small beside their mean by chance: kappa is below 2 for those
/// in [-1, 1), below 4 in [0.5, 2.5), below 7 in [1, 2).
Values tame_values(Rng& rng, std::size_t n, double low, double high);

/// offset + r + {4, 7, 13, 16} over and over in random order, r a whole number below 1000. Exact in
/// double up to offsets of 1e15; mean offset + r + 10, and 22.5 n/(n-1) for the variance.
Values shifted_pattern(Rng& rng, double offset, std::size_t n);

/// The data sets of NIST's Statistical Reference Datasets, "univariate summary statistics", NumAcc1
/// to NumAcc4, times a power of two, which changes no digit of anything.
Values numacc(int number, Rng& rng);

/// A list that is hard by what lies where in it.
struct HardList {
  const char* name;
  Values x;
  ExactMoments exact;
};

/// 100,001 values, all equal but one, which is 1e9 times as far from zero and comes first, in the
/// middle, or last: `of_each` lists of each kind. Shifting by that one squares all others to the
/// same large number, whose roundings add up: to n times what two passes lose (3,000 of 3,000 such
/// lists were below repeating_floor), or in blocks and lanes to a few times only (2,325 of 3,000:
/// five lists
/// leave one chance in a thousand to escape, less what several_outliers sees).
std::vector<HardList> one_outlier_lists(Rng& rng, int of_each);

/// 2^20 values, all equal but three outliers of different size, of which one comes first, one in
/// the middle, and one last.
HardList several_outliers(Rng& rng);

/// One outlier, sorted, a trend, alternating signs: a thousand values each.
std::vector<HardList> short_hard_lists(Rng& rng);

/// Finite values whose variance, 1e600 and more, is no double; and values that are not finite.
std::vector<Values> without_finite_variance(Rng& rng);

}  // namespace mc::checks
