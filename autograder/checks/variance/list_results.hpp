#pragma once
// How many digits a right algorithm keeps of exact values, computed here in 106 bits. Floors come
// from two bounds (Chan, Golub, LeVeque 1983, table 2), with a digit of room for their constants:
//
//   n eps          what n additions may lose in any order       two passes, shifted, in blocks
//   n kappa eps    what a mean rounded n times may lose,        one pass (Welford, merging)
//                  kappa = sqrt(1 + mean^2 / variance)
//
// Roundings that scatter lose sqrt(n) instead of n: one to three digits less.

#include "1-variance/experiments.hpp"
#include "checks/support/checks.hpp"
#include "data_sets.hpp"

namespace mc::checks {

inline constexpr double eps = std::numeric_limits<double>::epsilon();
inline constexpr double room = 1;  // digits

inline double floor_of(double lost) {
  return std::min(16.0, -std::log10(lost)) - room;
}
inline double two_pass_floor(std::size_t n) {
  return floor_of(static_cast<double>(n) * eps);
}

/// Of a mean: a sum loses n eps of the sum of absolute values (Higham 2002, section 4.2), which may
/// be much larger than the sum where values cancel.
inline double mean_floor(const List& list) {
  double sum_of_sizes = 0;
  for (const double value : list.x) sum_of_sizes += std::abs(value);
  const double sum = std::abs(static_cast<double>(list.exact.mean)) * list.exact.count;
  const double cancellation = sum > 0 ? std::max(1.0, sum_of_sizes / sum) : 1;
  return floor_of(list.exact.count * cancellation * eps);
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

inline const std::string because_sum =
    "n additions lose at most n eps of the sum of |x|, in any order; one digit less is enough";
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

/// All 64 bits of a count.
inline Exact exact_count(std::uint64_t count) {
  return Exact(static_cast<double>(count >> 32) * 0x1p32) +
         Exact(static_cast<double>(count & 0xffffffffu));
}

inline ExactMoments exact_merge(const Moments& a, const Moments& b) {
  const Exact n_a = exact_count(a.count), n_b = exact_count(b.count);
  const Exact n = n_a + n_b;
  const Exact apart = Exact(b.mean) - Exact(a.mean);
  ExactMoments all;
  if (a.count + b.count == 0) return all;
  all.count = static_cast<double>(n);
  all.mean = Exact(a.mean) + apart * n_b / n;
  all.m2 = Exact(a.m2) + Exact(b.m2) + apart * apart * n_a / n * n_b;
  return all;
}

/// Sample variances: `measure` asks for that of a list, `floor` gives the digits it keeps.
template <class Measure, class Floor>
Results variances_of(const std::vector<List>& lists, Measure measure, Floor floor) {
  Results variances;
  for (const List& list : lists) {
    const auto got = measure(list.x);
    variances.add_digits(got.call + list.name, got.value, list.exact.variance, floor(list.exact),
                         [&list] { return variance_suspects(list); });
  }
  return variances;
}

/// NaN for fewer than two values; neither finite for values without a finite variance.
template <class Measure>
void expect_no_variance(Rng& rng, Measure measure) {
  for (const Values& x : {Values{uniform(rng, -1, 1)}, Values{}}) {
    const auto got = measure(x);
    expect_nan(got.call, got.value, "a sample variance needs two values; " + because_undefined);
  }
  for (const Values& x : without_finite_variance(rng)) {
    const auto got = measure(x);
    expect_not_finite(got.call, got.value, x);
  }
}

class MomentsResults {
 public:
  /// Ends the check where the count is wrong. `list` must outlive these results.
  void add(const std::string& call, const Moments& got, const List& list, double m2_floor) {
    expect_that(got.count == list.x.size(), fmt::format("{}.count = {}", call, got.count),
                fmt::format("{}", list.x.size()), "",
                got.count == 0 ? "the count stays 0"
                               : "every value counts once, also those in a last, shorter block");
    const auto mean = static_cast<double>(list.exact.mean), m2 = static_cast<double>(list.exact.m2);
    means_.add(call + ".mean" + list.name, got.mean, mean, mean_tolerance(list.exact),
               [&list] { return mean_suspects(list); });
    m2s_.add_digits(call + ".m2" + list.name, got.m2, m2, m2_floor,
                    [&list] { return m2_suspects(list); });
  }

  void expect(const std::string& because, const std::string& of_mean, const std::string& of_m2) {
    means_.is_tame = m2s_.is_tame = is_tame;
    means_.expect(because, of_mean);
    m2s_.expect(because, of_m2);
  }

  bool is_tame = false;

 private:
  Results means_, m2s_;
};

/// Moments{}: count, mean and m2 are 0.
inline void expect_nothing(const std::string& call, const Moments& got, const std::string& hint) {
  expect_that(got.count == 0 && got.mean == 0 && got.m2 == 0, call + " = " + shown(got),
              "count, mean and m2 all 0", "there are no values", hint);
}

}  // namespace mc::checks
