#include "expect_variance.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include <fmt/format.h>

namespace mc::checks {
namespace {

/// The scale of the numbers is no matter: the variance of {c, 2c, 3c} is c^2.
void expect_any_scale(Rng& rng, const Algorithm& by) {
  const double large = uniform(rng, 1, 9) * 1e150;
  const Values large_values{large, 2 * large, 3 * large};
  const auto big = by.variance(large_values);
  expect_digits(big.call, big.value, large * large, two_pass_floor(3),
                "the variance of {c, 2c, 3c} is c^2, a double here",
                by.hints(big.value, large_values, exact_moments(large_values),
                         "does anything overflow that need not: a product, a float?"));
  const double tiny = uniform(rng, 1, 9) * 1e-160;
  const Values tiny_values{tiny, 2 * tiny, 3 * tiny};
  const auto small = by.variance(tiny_values);
  expect_within(small.call, small.value, tiny * tiny, 4 * std::numeric_limits<double>::denorm_min(),
                "the variance is about 1e-320, a denormal with a few bits left",
                by.hints(small.value, tiny_values, exact_moments(tiny_values),
                         "small is not zero: use no threshold"));
}

void expect_list(const Algorithm& by, const HardList& list, double floor,
                 const std::string& because, const std::string& otherwise) {
  const auto got = by.variance(list.x);
  const bool holds = digits(got.value, list.exact.variance) >= floor;  // no need of hints then
  expect_digits(fmt::format("{}, {}", got.call, list.name), got.value, list.exact.variance, floor,
                because, holds ? Hints{} : by.hints(got.value, list.x, list.exact, otherwise));
}

}  // namespace

void expect_hard_variance(Rng& rng, const Algorithm& by) {
  for (const HardList& list : short_hard_lists(rng)) {
    expect_list(by, list, by.floor(list.exact), by.because, "a sum that starts far from the mean?");
  }
  std::vector<HardList> outliers = one_outlier_lists(rng, by.outlier_lists);
  outliers.push_back(several_outliers(rng));
  for (const HardList& list : outliers) {
    expect_list(by, list, std::min(by.floor(list.exact), repeating_floor(list.x.size())),
                because_repeating,
                "is everything measured from a value that may lie far from all others?");
  }
  expect_any_scale(rng, by);
  for (const Values& x : without_finite_variance(rng)) {
    const auto got = by.variance(x);
    expect_no_number(got.call, got.value, x);
  }
}

void expect_no_number(const std::string& call, double got, const Values& x) {
  const bool has_others =
      !std::all_of(x.begin(), x.end(), [](double v) { return std::isfinite(v); });
  expect_that(!std::isfinite(got), fmt::format("{} = {}", call, got), "inf or NaN",
              has_others ? "one of the values is infinite or NaN: a finite result hides it"
                         : "the variance is 1e600 or more, which no double holds",
              "a finite number is wrong here; is it std::max(0.0, NaN), which is 0?");
}

void expect_moments(const std::string& call, const Moments& got, const ExactMoments& exact,
                    double mean_floor, double m2_floor, const std::string& because,
                    const Hints& mean_hints, const Hints& m2_hints) {
  expect_that(static_cast<double>(got.count) == exact.count,
              fmt::format("{}.count = {}", call, got.count), fmt::format("{}", exact.count), "",
              got.count == 0 ? "count is never set"
                             : "every value counts once, also those in a last, shorter block");
  expect_digits(call + ".mean", got.mean, static_cast<double>(exact.mean), mean_floor, because,
                mean_hints);
  if (exact.m2.high == 0) {
    expect_within(call + ".m2", got.m2, 0, 0, "one value does not deviate from itself", m2_hints);
  } else {
    expect_digits(call + ".m2", got.m2, static_cast<double>(exact.m2), m2_floor, because, m2_hints);
  }
}

void expect_nothing(const std::string& call, const Moments& got, const std::string& because,
                    const std::string& hint) {
  expect_that(got.count == 0 && got.mean == 0 && got.m2 == 0, call + " = " + shown(got),
              "count, mean and m2 all 0", because, hint);
}

}  // namespace mc::checks
