#pragma once
// How many correct digits an algorithm must keep: "floors". Exact values have 106 bits. The floors
// come from two bounds (Chan, Golub, LeVeque 1983, table 2), with a digit of slack:
//
//   n eps          the loss of n additions in any order         two passes, shifted, in blocks
//   n kappa eps    the loss of a mean rounded n times,          one pass (Welford, merging)
//                  kappa = sqrt(1 + mean^2 / variance)
//
// Random rounding errors lose sqrt(n) instead of n: one to three digits less.

#include "1-variance/experiments.hpp"
#include "checks/support/checks.hpp"
#include "data_sets.hpp"

namespace mc::checks {

inline constexpr double slack = 1;  // digits

inline double floor_of(double lost) {
  return std::min(16.0, -std::log10(lost)) - slack;
}
inline double two_pass_floor(const ExactMoments& exact) {
  return floor_of(exact.count * eps);
}

/// For a mean: a sum loses n eps of the sum of absolute values (Higham 2002, section 4.2), which
/// may be much larger than the sum if values cancel.
inline double mean_floor(const List& list) {
  double sum_of_sizes = 0;
  for (const double value : list.x) sum_of_sizes += std::abs(value);
  const double sum = std::abs(static_cast<double>(list.exact.mean)) * list.exact.count;
  const double cancellation = sum > 0 ? std::max(1.0, sum_of_sizes / sum) : 1;
  return floor_of(list.exact.count * cancellation * eps);
}

/// For a mean: n additions, or n rounding errors of a running mean.
inline double mean_tolerance(const ExactMoments& exact) {
  const double sigma = exact.count < 2 ? 0 : std::sqrt(exact.variance);
  return 10 * std::max(exact.count, 15.0) * eps *
         std::hypot(static_cast<double>(exact.mean), sigma);
}

inline double one_pass_floor(const ExactMoments& exact) {
  return floor_of(exact.count * condition(exact) * eps);
}

/// Repeated values have the same rounding error: n of them lose n/4 eps. A digit and a half of
/// slack, as the header of 1.8 allows.
inline double repeating_floor(double n) {
  return -std::log10(n / 4 * eps) - 1.5;
}

inline const std::string because_sum =
    "n additions lose at most n eps of the sum of |x|; one digit of slack";

inline const std::string because_one_pass =
    "a running mean is rounded n times to eps |mean|, which changes the variance by a fraction eps "
    "|mean| / sigma each time; one digit of slack";
inline const std::string because_repeating =
    "n equal rounding errors lose n/4 eps; slack: 1.5 digits";
inline const std::string because_undefined = "an undefined result is NaN, as in NumPy and R";
inline const std::string stop_at_zero = "the rounded correction may exceed the sum: then return 0";

/// A count, with all of its 64 bits.
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

/// Sample variances: `measure` requests that of a list, `floor` returns the required digits.
template <class Measure, class Floor>
Results variances_of(const std::vector<List>& lists, Measure measure, Floor floor) {
  Results variances;
  for (const List& list : lists) {
    const auto got = measure(list.x);
    variances.add_digits(
        got.call + list.name, got.value, list.exact.variance, floor(list.exact),
        [&list, value = got.value] {
          std::vector<Suspect> suspects = variance_suspects(list);
          suspects.push_back({value == 0 ? 0 : list.exact.variance,
                              "small is not zero: use no (relative) threshold"_likely});
          return suspects;
        },
        list.x.size());
  }
  return variances;
}

/// The variance is NaN for fewer than two values, and not finite if the exact one is not. Each
/// function that returns a variance can get this wrong: 0 for one value, std::max(0.0, NaN).
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
  /// Ends the check if the count is wrong. `list` must outlive these results.
  void add(const std::string& call, const Moments& got, const List& list, double m2_floor) {
    expect_equal(call + ".count", got.count, list.x.size(), "",
                 got.count == 0
                     ? "the count stays 0"
                     : "every value counts once, including those of a shorter last block");
    const auto mean = static_cast<double>(list.exact.mean), m2 = static_cast<double>(list.exact.m2);
    means_.add(call + ".mean" + list.name, got.mean, mean, mean_tolerance(list.exact),
               [&list] { return mean_suspects(list); });
    m2s_.add_digits(
        call + ".m2" + list.name, got.m2, m2, m2_floor, [&list] { return m2_suspects(list); },
        list.x.size());
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
