#pragma once
// What the variances are taken of, fresh in each run, and what well-known mistakes give for it: all
// of that is computed in double, as a submission would.

#include "checks/support/checks.hpp"

namespace mc::checks {

using Values = std::vector<double>;

/// Values, and their moments.
struct List {
  explicit List(Values values, std::string words = {});
  List(Values values, std::string words, ExactMoments moments);

  Values x;
  std::string name;  ///< ", NIST's NumAcc1": follows the call in a report
  ExactMoments exact;
};

/// Uniform values of which the first two lie in the first and in the last quarter, so that the
/// variance of two or three is never small compared with their mean by chance: kappa is below 2 for
/// those in [-1, 1), below 4 in [0.5, 2.5), below 7 in [1, 2).
Values tame_values(Rng& rng, std::size_t n, double low, double high);

/// Lists of them: first three that differ in one value, which shows what is kept between calls, and
/// in one of them is 0; then one of every size of domain::sizes() from `least` up to 65,537.
std::vector<List> tame_lists(Rng& rng, std::size_t least, double low, double high);

/// offset + r + {4, 7, 13, 16} over and over in random order, r a whole number below 1000. Exact in
/// double up to offsets of 1e15; mean offset + r + 10, and 22.5 n/(n-1) for the variance.
Values shifted_pattern(Rng& rng, double offset, std::size_t n);

/// Such patterns of n values far from zero; and the data sets of NIST's Statistical Reference
/// Datasets, "univariate summary statistics", NumAcc1 to NumAcc4, times a power of two, which
/// changes no digit of anything.
std::vector<List> lists_with_large_means(Rng& rng, std::vector<std::size_t> sizes);

/// 100,001 values, all equal but one, which is 1e9 times as far from zero and comes first, in the
/// middle, or last: `of_each` lists of each kind. Shifting by that one squares all others to the
/// same large number, whose roundings add up: below repeating_floor in 3,000 of 3,000 such lists,
/// in blocks and lanes in 2,325. The last one is 2^20 values, all equal but three outliers.
std::vector<List> lists_with_outliers(Rng& rng, int of_each);

/// One outlier, sorted, a trend, alternating signs: a thousand values each.
std::vector<List> short_hard_lists(Rng& rng);

/// {c, 2c, 3c} with a variance of c^2, the largest and the smallest that a double holds; and zeros.
std::vector<List> lists_of_any_scale(Rng& rng);

/// Finite values whose variance, 1e600 and more, is not a double; then values with a NaN or an
/// infinity in the first place, in the last, or between.
std::vector<Values> without_finite_variance(Rng& rng);
std::vector<Values> with_a_value_that_is_not_finite(Rng& rng);

/// `got`, a result for `x`, is infinite or NaN.
void expect_not_finite(const std::string& call, double got, const Values& x);

/// For a mean.
std::vector<Suspect> mean_suspects(const List& list);

/// For a sample variance: its scale, and other ways to it than the one that was asked for.
std::vector<Suspect> variance_suspects(const List& list);

/// The same for a sum of squared deviations, `divided` by something or by nothing.
std::vector<Suspect> m2_suspects(const List& list);

/// The corrected two-pass variance, not stopped at 0.
double two_pass_here(const Values& x);

}  // namespace mc::checks
