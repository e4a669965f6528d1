// 1.8: the moments of a list, fast.

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "1-variance/experiments.hpp"
#include "checks/support/catch.hpp"
#include "expect_variance.hpp"
#include "known_ways.hpp"

namespace mc::checks {
namespace {

const std::string short_block =
    "does every value count once, also those in a last, shorter block? Is any sum a float?";

const std::string first_value =
    "these are the digits of sums about the first value, which may lie far from all others";

/// For the mean and for m2 of a list whose moments are wrong.
std::pair<Hints, Hints> moments_hints(const Moments& got, const Values& x,
                                      const ExactMoments& exact, const std::string& otherwise) {
  const double mean = static_cast<double>(exact.mean), m2 = static_cast<double>(exact.m2);
  const double n = exact.count;
  const About about_first = about(x, x.front());
  return {
      {nearest(got.mean, mean,
               {{mean * n, "this is the sum: divide it by the count"},
                {about_first.mean, first_value}}),
       digits(got.mean, mean) < 1
           ? "the mean is far off: was the shift put back, are the parts weighted by their counts?"
           : otherwise},
      {nearest(got.m2, m2,
               {{exact.variance, "m2 is a sum: variance() divides it, once"},
                {exact.variance * n, "this is n times the sample variance: m2 is n - 1 times it"},
                {textbook_from_means(x) * (n - 1), large_numbers},
                {textbook_from_sums(x) * (n - 1), large_numbers},
                {uncorrected_here(x) * (n - 1), uncorrected},
                {about_first.m2, first_value},
                {welford_here(x).m2, running_mean}}),
       otherwise + (x.size() > 1 ? kept_by_known_ways(x, exact) : "")}};
}

void expect_fast(const std::string& name, const Values& x, const ExactMoments& exact,
                 double m2_floor, const std::string& because, const std::string& otherwise) {
  const auto got = MEASURE(moments, x);
  const double mean_floor = std::min(two_pass_floor(x.size()), 13.5);
  const bool holds = digits(got.value.mean, static_cast<double>(exact.mean)) >= mean_floor &&
                     digits(got.value.m2, static_cast<double>(exact.m2)) >= m2_floor;
  const auto [mean_hints, m2_hints] =  // no need of any where all is well
      holds ? std::pair<Hints, Hints>{} : moments_hints(got.value, x, exact, otherwise);
  expect_moments(name.empty() ? got.call : got.call + ", " + name, got.value, exact, mean_floor,
                 m2_floor, because, mean_hints, m2_hints);
}

CHECK_CASE("1.8 the moments of a list of any length", "[1.8][main][points:4]") {
  Rng rng = check_rng();
  // Lengths are judged here, digits below: a value too many or too few changes m2 by a part 1/n.
  const auto judge = [&](std::size_t n) {
    const auto x = tame_values(rng, n, 1, 2);
    const auto exact = exact_moments(x);
    const double kappa = condition(exact);
    expect_fast("", x, exact, floor_of(static_cast<double>(n) * eps * kappa * kappa),
                "even E{X^2} - E{X}^2 loses no more than n eps E{X^2} / Var{X}", short_block);
  };
  for (const std::size_t n : {1000u, 4096u, 10007u, 1023u, 1025u, 64u, 31u, 7u, 3u, 2u, 1u}) {
    judge(n);
  }
  judge(50 + rng() % 2000);
}

CHECK_CASE("1.8 the moments of no values", "[1.8][edge][points:1]") {
  const auto none = MEASURE(moments, {});
  expect_nothing(none.call, none.value, "there are no values",
                 "nothing to add, nothing to divide by");
}

/// As many digits as 1.3 keeps, 15 at most, less a digit and a half. What 1.3 keeps is measured,
/// but not taken at more than n roundings leave that scatter, sqrt(n) eps: beyond that it was luck,
/// which is no standard for another order of additions. (n equal roundings lose n/4 eps: for the
/// values here that can repeat, n < 5000, this is within the digit and a half.)
void expect_digits_of_two_passes(const std::string& name, const Values& x,
                                 const std::string& otherwise) {
  const auto exact = exact_moments(x);
  const double best = std::min({digits(two_pass_here(x), exact.variance), 15.0,
                                -std::log10(std::sqrt(static_cast<double>(x.size())) * eps)});
  expect_fast(name, x, exact, best - 1.5,
              fmt::format("two passes keep {:.1f} digits here; 1.5 may be lost", best), otherwise);
}

CHECK_CASE("1.8 the moments keep their digits on hard data", "[1.8][points:3]") {
  Rng rng = check_rng();
  const std::string rounded =
      "is a mean rounded here before it is compared? Near 1e9 that costs 1e-7; offsets from one "
      "value near the data have nothing to lose";
  for (const double offset : {1e9, 1e12, 1e15, 1e6}) {
    expect_digits_of_two_passes("", shifted_pattern(rng, offset, 4096), rounded);
  }
  for (const int number : {1, 2, 3, 4}) {
    expect_digits_of_two_passes(fmt::format("NIST's NumAcc{}", number), numacc(number, rng),
                                rounded);
  }
  Values sorted = uniform_values(rng, 10000, 1e9, 1e9 + 1);
  std::sort(sorted.begin(), sorted.end());
  expect_digits_of_two_passes("sorted", sorted, rounded);
  Values trend = uniform_values(rng, 100000, 0, 1);
  for (std::size_t i = 0; i < trend.size(); ++i) trend[i] += static_cast<double>(i);
  expect_digits_of_two_passes("a trend", trend, "a shift must be near all of the data");
  for (const double c : {0.1, uniform(rng, 1e8, 1e9)}) {
    // The promise of 1.3: a variance of (eps c)^2 at most.
    const Values x(4096, c);
    const auto got = MEASURE(moments, x);
    const std::string because =
        "these values do not vary: m2 <= n (eps c)^2, and no sum of squares "
        "is negative";
    expect_within(got.call + ".m2", got.value.m2, 0, 4096 * eps * eps * c * c, because,
                  {{}, rounded});
    expect_that(got.value.m2 >= 0, fmt::format("{}.m2 = {}", got.call, got.value.m2),
                "0, never less", because, stop_at_zero);
  }
  for (const Values& x : without_finite_variance(rng)) {
    const auto got = MEASURE(moments, x);
    expect_no_number(got.call + ".m2", got.value.m2, x);
  }
}

CHECK_CASE("1.8 the moments keep their digits beside outliers", "[1.8][points:2]") {
  Rng rng = check_rng();
  const std::string far_shift =
      "is everything measured from a value that may lie far from all others? A shift belongs near "
      "most of the data";
  std::vector<HardList> lists = one_outlier_lists(rng, 5);
  lists.push_back(several_outliers(rng));
  for (const HardList& list : lists) {
    expect_fast(list.name, list.x, list.exact, repeating_floor(list.x.size()), because_repeating,
                far_shift);
  }
  for (const std::size_t place : {std::size_t{0}, std::size_t{1 + rng() % 99'999}}) {
    Values x = uniform_values(rng, 100'000, 0, 1);
    x[place] = 1e9;
    expect_digits_of_two_passes(place == 0 ? "an outlier comes first" : "one outlier", x,
                                far_shift);
  }
}

}  // namespace
}  // namespace mc::checks
