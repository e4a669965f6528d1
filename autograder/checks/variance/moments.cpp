// 1.8: the moments of a list, fast.

#include <algorithm>
#include <cmath>

#include "1-variance/experiments.hpp"
#include "checks/support/catch.hpp"
#include "list_results.hpp"

namespace mc::checks {
namespace {

const std::string far_off =
    "if the mean is far off: was the shift put back, are the parts weighted by their counts?";

CHECK_CASE("1.8 the moments of a list of any length", "[1.8][main][points:4]") {
  Rng rng = check_rng();
  const std::vector<List> lists = tame_lists(rng, 1, 1, 2);
  MomentsResults all;
  all.is_tame = true;
  for (const List& list : lists) {
    // Lengths are judged here, digits below: a value too many or too few changes m2 by a part 1/n.
    const double n = list.exact.count, kappa = condition(list.exact);
    const auto got = MEASURE(moments, list.x);
    all.add(got.call, got.value, list, n > 1 ? floor_of(n * eps * kappa * kappa) : 0);
  }
  all.expect("even E{X^2} - E{X}^2 loses no more than n eps E{X^2} / Var{X}", far_off,
             "does every value count once, also those in a last, shorter block?");
}

CHECK_CASE("1.8 the moments of no values", "[1.8][edge][points:1]") {
  const auto none = MEASURE(moments, {});
  expect_nothing(none.call, none.value, "nothing to add, nothing to divide by");
}

/// As many digits as 1.3 keeps, 15 at most, less a digit and a half. What 1.3 keeps is measured,
/// but not taken at more than n roundings leave that scatter, sqrt(n) eps: beyond that it was luck,
/// which is no standard for another order of additions. (n equal roundings lose n/4 eps: for the
/// values here that can repeat, n < 5000, this is within the digit and a half.)
void judge_moments(const std::vector<List>& lists, const std::string& otherwise) {
  MomentsResults all;
  for (const List& list : lists) {
    const std::size_t n = list.x.size();
    const double best = std::min({digits(two_pass_here(list.x), list.exact.variance), 15.0,
                                  -std::log10(std::sqrt(static_cast<double>(n)) * eps)});
    const auto got = MEASURE(moments, list.x);
    all.add(got.call, got.value, list, best - 1.5);
  }
  all.expect("two corrected passes keep 1.5 digits more of these data", otherwise, otherwise);
}

CHECK_CASE("1.8 the moments keep their digits on hard data", "[1.8][points:3]") {
  Rng rng = check_rng();
  const std::string rounded =
      "is a mean rounded here before it is compared? Near 1e9 that costs 1e-7; offsets from one "
      "value near the data have nothing to lose";
  judge_moments(lists_with_large_means(rng, {4096, 4, 33}), rounded);
  Values sorted = uniform_values(rng, 10'000, 1e9, 1e9 + 1), trend(100'000);
  std::sort(sorted.begin(), sorted.end());
  judge_moments({List(sorted, ", sorted")}, rounded);
  for (std::size_t i = 0; i < trend.size(); ++i) trend[i] = uniform(rng) + static_cast<double>(i);
  judge_moments({List(trend, ", a trend")}, "a shift must be near all of the data");
  judge_moments(lists_of_any_scale(rng), "small is not zero: use no threshold, no float");
  for (const double c : {0.1, uniform(rng, 1e8, 1e9), -uniform(rng, 1, 2)}) {
    for (const std::size_t n : {4096u, 2u, 63u, 1000u, 1u}) {
      const auto got = MEASURE(moments, Values(n, c));
      const double most = static_cast<double>(n) * eps * eps * c * c;  // a variance as 1.3 promises
      expect_that(got.value.m2 >= 0 && got.value.m2 <= most,
                  fmt::format("{}.m2 = {}", got.call, got.value.m2),
                  fmt::format("from 0 to {:.3g}", most),
                  "these values do not vary: m2 <= n (eps c)^2, and no sum of squares is negative",
                  got.value.m2 < 0 ? stop_at_zero : rounded);
    }
  }
  for (const Values& x : without_finite_variance(rng)) {
    const auto got = MEASURE(moments, x);
    expect_no_number(got.call + ".m2", got.value.m2, x);
  }
}

CHECK_CASE("1.8 the moments keep their digits in spite of outliers", "[1.8][points:2]") {
  Rng rng = check_rng();
  const std::string far_shift =
      "is everything measured from a value that may lie far from all others? A shift belongs near "
      "most of the data";
  const std::vector<List> lists = lists_with_outliers(rng, 5);
  MomentsResults all;
  for (const List& list : lists) {
    const auto got = MEASURE(moments, list.x);
    all.add(got.call, got.value, list, repeating_floor(list.exact.count));
  }
  all.expect(because_repeating, far_shift, far_shift);
  std::vector<List> others;
  for (const std::size_t n : {100'000u, 5000u, 100u, 64u, 16u}) {
    for (const std::size_t place : {std::size_t{0}, n / 4, n / 2, n - 1, std::size_t{rng() % n}}) {
      Values x = uniform_values(rng, n, 0, 1);
      x[place] = 1e9;
      others.emplace_back(x, fmt::format(", an outlier at {}", place));
    }
  }
  judge_moments(others, far_shift);
}

}  // namespace
}  // namespace mc::checks
