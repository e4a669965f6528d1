// 1.1: the mean.

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "1-variance/experiments.hpp"
#include "checks/support/catch.hpp"
#include "expect_variance.hpp"
#include "known_ways.hpp"

namespace mc::checks {
namespace {

CHECK_CASE("1.1 the mean of a list of values", "[1.1][main][points:5]") {
  Rng rng = check_rng();
  for (const std::size_t n : {10u, 1000u, 3u, 2u, 1u}) {
    const auto x = uniform_values(rng, n, 1, 2);
    const auto got = MEASURE(mean, x);
    const double exact = static_cast<double>(exact_mean(x));
    const auto size = static_cast<double>(n);
    expect_digits(
        got.call, got.value, exact, two_pass_floor(n), because_two_pass,
        {nearest(got.value, exact,
                 {{sum_in_whole_numbers(x) / size,
                   "the sum is cut off to a whole number at each step: std::accumulate(…, 0) adds "
                   "in int; begin with 0.0"},
                  {exact * size / (size - 1), "this divides by n - 1; only the variance does"},
                  {exact * size, "this is the sum: divide it by n"}}),
         or_float(got.value, exact, "add the values up and divide by how many there are")});
  }
  for (const int number : {1, 2, 3, 4}) {
    const auto x = numacc(number, rng);
    const auto got = MEASURE(mean, x);
    expect_digits(fmt::format("{}, NIST's NumAcc{}", got.call, number), got.value,
                  static_cast<double>(exact_mean(x)), two_pass_floor(x.size()), because_two_pass,
                  {{}, "is every sum a double? A float keeps seven digits"});
  }
}

CHECK_CASE("1.1 the mean of nothing is NaN", "[1.1][edge][points:1]") {
  const auto nothing = MEASURE(mean, {});
  expect_nan(nothing.call, nothing.value, "the mean of nothing is 0/0; " + because_undefined);
}

CHECK_CASE("1.1 the mean is finite wherever it is a double", "[1.1][edge][points:3]") {
  Rng rng = check_rng();
  const double huge = uniform(rng, 1.6e308, 1.79e308);
  const std::string because =
      "a mean lies between the smallest and the largest value, so it is finite";
  const Hints hints{{{huge * 0.4, "this divides by n - 1; only the variance does"}},
                    "the sum overflows where the mean does not: notice it, and sum x/n instead; a "
                    "float ends at 3.4e38 already"};
  const Hints negative{{}, "a sum can overflow to -inf as well: is |sum| looked at, or sum only?"};
  for (const double value : {1e308, huge}) {
    const auto two = MEASURE(mean, {value, value});
    expect_digits(two.call, two.value, value, two_pass_floor(2), because, hints);
    const auto below = MEASURE(mean, {-value, -value});
    expect_digits(below.call, below.value, -value, two_pass_floor(2), because, negative);
  }

  Values opposite;
  for (int i = 0; i < 6; ++i) opposite.push_back(i < 4 ? huge : -huge);
  for (const double sign : {1.0, -1.0}) {
    const auto cancelling = MEASURE(mean, opposite);
    expect_digits(cancelling.call, cancelling.value, sign * huge / 3, two_pass_floor(20), because,
                  sign > 0 ? hints : negative);
    for (double& value : opposite) value = -value;
  }
  const auto both = MEASURE(mean, {huge, -huge, huge, -huge});
  expect_within(both.call, both.value, 0, huge * 8 * eps, because, hints);

  Values many(1000);
  for (double& value : many) value = uniform(rng, 1e308, 1.79e308);
  Values smaller = many;  // 2^-20 times the data, exactly: sums that fit
  for (double& value : smaller) value *= 0x1p-20;
  const auto most = MEASURE(mean, many);
  expect_digits(most.call, most.value, static_cast<double>(exact_mean(smaller)) * 0x1p20,
                two_pass_floor(1000), because, hints);
}

CHECK_CASE("1.1 the mean hides no infinity and no NaN", "[1.1][edge][points:1]") {
  Rng rng = check_rng();
  for (const Values& x : without_finite_variance(rng)) {
    if (std::all_of(x.begin(), x.end(), [](double value) { return std::isfinite(value); }))
      continue;
    const auto got = MEASURE(mean, x);
    expect_no_number(got.call, got.value, x);
  }
}

}  // namespace
}  // namespace mc::checks
