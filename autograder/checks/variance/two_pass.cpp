// 1.3: two passes, corrected.

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "1-variance/experiments.hpp"
#include "checks/support/catch.hpp"
#include "expect_variance.hpp"
#include "known_ways.hpp"

namespace mc::checks {
namespace {

Variance by_two_passes(const Values& x) {
  const auto got = MEASURE(variance_two_pass, x);
  return {got.value, got.call};
}

CHECK_CASE("1.3 the two-pass variance of tame data", "[1.3][main][points:5][needs:1.1]") {
  Rng rng = check_rng();
  for (const std::size_t n : {10u, 1000u, 3u, 2u}) {
    const auto x = tame_values(rng, n, 0.5, 2.5);
    const auto exact = exact_moments(x);
    const auto got = by_two_passes(x);
    expect_digits(got.call, got.value, exact.variance, two_pass_floor(n), because_two_pass,
                  variance_hints(got.value, x, exact, "sum (x - mean)^2 and divide by n - 1"));
  }
}

CHECK_CASE("1.3 fewer than two values have no variance", "[1.3][edge][points:1]") {
  Rng rng = check_rng();
  for (const Values& x : {Values{uniform(rng, -1, 1)}, Values{}}) {
    const auto got = by_two_passes(x);
    expect_nan(got.call, got.value, "a sample variance needs two values; " + because_undefined);
  }
}

CHECK_CASE("1.3 two passes keep their digits under a large mean", "[1.3][points:5][needs:1.1]") {
  Rng rng = check_rng();
  const auto judge = [](const Values& x, const std::string& name) {
    const auto exact = exact_moments(x);
    const auto got = by_two_passes(x);
    expect_digits(
        got.call + name, got.value, exact.variance, two_pass_floor(x.size()), because_two_pass,
        hard_variance_hints(got.value, x, exact,
                            "squared deviations from the mean, corrected for its rounding"));
  };
  for (const double offset : {1e9, 1e12, 1e15, 1e6, 1e13, 1e14}) {
    for (const std::size_t n : {1000u, 4u}) judge(shifted_pattern(rng, offset, n), "");
  }
  for (const int number : {1, 2, 3, 4}) {
    judge(numacc(number, rng), fmt::format(", NIST's NumAcc{}", number));
  }
}

CHECK_CASE("1.3 the variance of constant data is zero", "[1.3][edge][points:3][needs:1.1]") {
  Rng rng = check_rng();
  const auto expect_not_negative = [](const std::string& call, double got) {
    expect_that(got >= 0, fmt::format("{} = {}", call, got), "0, never less",
                "a variance is a mean of squares", stop_at_zero);
  };
  const auto pattern = shifted_pattern(rng, 0, 1000);  // beside it, so that 0 is no answer
  const auto varying = by_two_passes(pattern);
  expect_digits(varying.call, varying.value, exact_moments(pattern).variance, 2,
                "these values are not constant", {{}, "see the first check of this task"});
  // A sum of n equal values is off by n^2/4 eps |c| at most, the mean by d = n/4 eps |c|; every
  // deviation is d, and what the correction leaves of n d^2 is again a rounding error, 3/4 n eps of
  // it. That is 3/64 n^3 eps (eps c)^2 in all: 1 % of (eps c)^2 for n = 1e5 (a tenth, if the sums
  // are taken in an unlucky order), and nothing where the mean is corrected first.
  for (const double c : {0.1, 1e8 / 3, uniform(rng, 1, 2), -uniform(rng, 1e5, 1e6)}) {
    for (const std::size_t n : {1000u, 100000u, 2u}) {
      const Values x(n, c);
      const auto got = by_two_passes(x);
      expect_within(got.call, got.value, 0, eps * eps * c * c,
                    "a rounded mean may be wrong by n eps |c|, but the correction leaves less than "
                    "one rounding of c, squared",
                    [&]() -> Hints {
                      return {nearest(got.value, 0,
                                      {{uncorrected_here(x),
                                        "the rounded mean is not c: take (sum of deviations)^2 / n "
                                        "off"},
                                       {textbook_from_means(x), large_numbers},
                                       {textbook_from_sums(x), large_numbers}}),
                              "measure from the mean, and take back what its rounding adds"};
                    });
      expect_not_negative(got.call, got.value);
    }
  }
  // Up to n = 3e5 or so the two parts of eq. 1.7 are whole multiples of ulp(c)^2, exact in double,
  // and differ by 0. At this n, their difference is below 0 for half of all constants where sums
  // are taken one after the other, for a fifth in four lanes, for one of fourteen in sixteen.
  constexpr std::uint64_t many = 3'000'000;
  const auto expect_none_below_zero = [&](const Values& constants) {
    const auto got = MEASURE(two_pass_of_constants, constants, many);
    const auto& variances = got.exactly(constants.size(), any_number);
    for (std::size_t k = 0; k < constants.size(); ++k) {
      expect_not_negative(fmt::format("{}[{}]", got.call, k), variances[k]);
    }
  };
  for (int i = 0; i < 2; ++i) expect_none_below_zero(uniform_values(rng, 3, 1, 2));
  // Of 700 random constants, those for which it is below 0 most often, over 1, 2, 4, 8 and 16
  // lanes, added up one by one or in pairs, the mean by one lane or by as many: each of these ways
  // has three constants at least. A power of two scales all of it exactly.
  const double scale = std::ldexp(rng() % 2 == 0 ? 1 : -1, static_cast<int>(rng() % 40) - 20);
  for (Values constants : {Values{1.9913159685236592, 1.2969464825440495, 1.3617208224630535},
                           Values{1.0744250400711668, 1.8192433745648477},
                           Values{1.021024228416727, 1.6582207134973537}}) {
    for (double& constant : constants) constant *= scale;
    expect_none_below_zero(constants);
  }
}

CHECK_CASE("1.3 two passes on hard cases", "[1.3][points:3][needs:1.1]") {
  Rng rng = check_rng();
  expect_hard_variance(rng, {by_two_passes,
                             [](const ExactMoments& exact) {
                               return two_pass_floor(static_cast<std::size_t>(exact.count));
                             },
                             because_two_pass, hard_variance_hints, 2});
}

CHECK_CASE("1.3 sigma of aX is the absolute value of a times sigma of X",
           "[1.3][points:1][needs:1.1]") {
  Rng rng = check_rng();
  // Whole numbers below 2^20, and a below 2^30 times a power of two: a x is exact.
  for (const double unit : {1.0, 0x1p-100, 0x1p100}) {
    Values x(100), ax(100);
    const double a = -(1 + static_cast<double>(rng() >> 34)) * unit;
    for (double& value : x) value = static_cast<double>(rng() >> 44);
    std::transform(x.begin(), x.end(), ax.begin(), [=](double value) { return a * value; });
    const auto of_x = by_two_passes(x), of_ax = by_two_passes(ax);
    const double sigma = std::abs(a) * std::sqrt(of_x.value);
    // Both variances have their digits; a square root halves what is lost.
    expect_digits(
        fmt::format("sqrt({})", of_ax.call), std::sqrt(of_ax.value), sigma,
        two_pass_floor(x.size()),
        fmt::format("Var{{aX}} = a^2 Var{{X}} with a = {}, and {} = {}", a, of_x.call, of_x.value),
        {{},
         "the result depends on the scale of the data: use no threshold and no constant of your "
         "own"});
    expect_digits(of_x.call, of_x.value, exact_moments(x).variance, 1,
                  "the variance of x itself must be right, too",
                  {{}, "see the first check of this task"});
  }
}

}  // namespace
}  // namespace mc::checks
