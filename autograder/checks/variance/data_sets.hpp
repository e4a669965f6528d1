#pragma once
// The random data of lab 1, and the results of mistakes, computed in double like a submission.

#include "checks/support/checks.hpp"

namespace mc::checks {

struct List {
  explicit List(Values values, std::string words = {});
  List(Values values, std::string words, ExactMoments moments);

  Values x;
  std::string name;  ///< ", NIST's NumAcc1": printed after the call
  ExactMoments exact;
};

/// Uniform values, the first two in the first and last quarter of the range, so that even two or
/// three have a variance that is not small compared with their mean: kappa is below 2 in [-1, 1),
/// below 4 in [0.5, 2.5), below 7 in [1, 2).
Values tame_values(Rng& rng, std::size_t n, double low, double high);

/// Lists of them: first three that differ in one value, which reveals state kept between calls, one
/// of them with a 0; then one list of each size of domain::sizes() from `least` to 65,537.
std::vector<List> tame_lists(Rng& rng, std::size_t least, double low, double high);

/// offset + r + {4, 7, 13, 16}, repeated and in random order, with an integer r below 1000. Exact
/// in double up to offsets of 1e15; the mean is offset + r + 10, the variance 22.5 n/(n-1).
Values shifted_pattern(Rng& rng, double offset, std::size_t n);

/// Such patterns far from zero; and NIST's Statistical Reference Datasets "univariate summary
/// statistics", NumAcc1 to NumAcc4, times a power of two, which changes no digits.
std::vector<List> lists_with_large_means(Rng& rng, std::vector<std::size_t> sizes);

/// 100,001 values, all equal except one outlier, 1e9 times as large, in the first, middle or last
/// place: `of_each` lists of each kind. Relative to the outlier, all other values have the same
/// large square, whose rounding errors add up: below repeating_floor() in 3,000 of 3,000 such
/// lists, and in 2,325 with blocks and lanes. The last list has three outliers in 2^20 values.
std::vector<List> lists_with_outliers(Rng& rng, int of_each);

/// A short list whose running mean is 0 at times; one outlier, sorted, a trend, alternating signs.
std::vector<List> short_hard_lists(Rng& rng);

/// {c, 2c, 3c}, with the variance c^2 near the largest or smallest double; and zeros.
std::vector<List> lists_of_any_scale(Rng& rng);

/// Values with a NaN or an infinity in the first place, the last, or between; and (only the first
/// function) finite values with a variance above 1e600, which is not a double.
std::vector<Values> without_finite_variance(Rng& rng);
std::vector<Values> with_a_value_that_is_not_finite(Rng& rng);

/// `got`, a result for `x`, is infinite or NaN.
void expect_not_finite(const std::string& call, double got, const Values& x);

std::vector<Suspect> mean_suspects(const List& list);

/// Suspects for a sample variance: wrong factors, and other algorithms than the requested one.
std::vector<Suspect> variance_suspects(const List& list);

/// The same for a sum of squared deviations.
std::vector<Suspect> m2_suspects(const List& list);

/// The corrected two-pass variance, which may be negative.
double two_pass_here(const Values& x);

}  // namespace mc::checks
