// 1.2: the textbook formula.

#include <fmt/format.h>

#include "1-variance/experiments.hpp"
#include "checks/support/catch.hpp"
#include "expect_variance.hpp"

namespace mc::checks {
namespace {

CHECK_CASE("1.2 the textbook formula gives the variance of tame data", "[1.2][main][points:5]") {
  Rng rng = check_rng();
  for (const std::size_t n : {10u, 1000u, 3u, 2u}) {
    const auto x = tame_values(rng, n, 0.5, 2.5);
    const auto exact = exact_moments(x);
    const auto got = MEASURE(variance_textbook, x);
    const double kappa = condition(exact);
    expect_digits(got.call, got.value, exact.variance,
                  floor_of(static_cast<double>(n) * eps * kappa * kappa),
                  "n additions lose n eps, and the difference magnifies it by E{X^2} / Var{X}",
                  variance_hints(got.value, x, exact, "E{X^2} - E{X}^2, times n/(n-1)"));
  }
}

CHECK_CASE("1.2 fewer than two values have no variance by the textbook", "[1.2][edge][points:1]") {
  Rng rng = check_rng();
  for (const Values& x : {Values{uniform(rng, -1, 1)}, Values{}}) {
    const auto got = MEASURE(variance_textbook, x);
    expect_nan(got.call, got.value, "a sample variance needs two values; " + because_undefined);
  }
}

CHECK_CASE("1.2 the textbook formula loses everything under a large mean",
           "[1.2][edge][points:4]") {
  Rng rng = check_rng();
  const auto tame = shifted_pattern(rng, 0, 1000);  // beside it, so that a constant is no answer
  const auto near_zero = MEASURE(variance_textbook, tame);
  expect_digits(near_zero.call, near_zero.value, exact_moments(tame).variance, 2,
                "the mean is below 1010 here, and costs six digits of sixteen at most",
                {{}, "E{X^2} - E{X}^2, times n/(n-1); see the check before this one"});
  for (const std::size_t n : {4u, 1000u}) {
    const auto x = shifted_pattern(rng, 1e9, n);
    const auto exact = exact_moments(x);
    const auto got = MEASURE(variance_textbook, x);
    // 1e18 has an ulp of 128: either form of the formula can only give a multiple of some
    // power of two that is far from 22.5 n/(n-1). Two digits would take an ulp below 0.4.
    expect_that(
        !(digits(got.value, exact.variance) >= 2),
        fmt::format("{} = {}, which has {:.1f} correct digits", got.call, got.value,
                    digits(got.value, exact.variance)),
        "a number with no right digit, as E{X^2} - E{X}^2 gives here in double",
        "this task shows how the formula fails: both terms are about 1e18, where doubles are 128 "
        "apart",
        "this is a better algorithm under the textbook's name, or a wider type; keep it for 1.3");
  }
}

}  // namespace
}  // namespace mc::checks
