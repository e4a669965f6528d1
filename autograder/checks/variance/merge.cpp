// 1.5: merging.

#include <algorithm>
#include <cmath>
#include <numeric>

#include <fmt/format.h>

#include "1-variance/experiments.hpp"
#include "checks/support/catch.hpp"
#include "exact_merge.hpp"
#include "expect_variance.hpp"

namespace mc::checks {
namespace {

Hints merged_mean_hints(double got, const Moments& a, const Moments& b, double mean) {
  const auto n_a = static_cast<double>(a.count), n_b = static_cast<double>(b.count);
  const std::string whole = "is the other part's weight, n_b / n, an integer division, which is 0?";
  return {nearest(got, mean,
                  {{(a.mean + b.mean) / 2, "the mean of two means is right only for equal counts"},
                   {n_a * a.mean + n_b * b.mean, "this is the sum of all values: divide by n"},
                   {a.mean, "this is the first part's mean alone: " + whole},
                   {b.mean, "this is the second part's mean alone: " + whole}}),
          "weigh the means by the counts: (n_a mean_a + n_b mean_b) / (n_a + n_b)", empty_part};
}

Hints merged_m2_hints(double got, const Moments& a, const Moments& b, double mean, double m2) {
  const auto n_a = static_cast<double>(a.count), n_b = static_cast<double>(b.count);
  const double n = n_a + n_b;
  const double apart = b.mean - a.mean;
  const double within = a.m2 + b.m2;
  const std::uint64_t whole_product = a.count * b.count, count = a.count + b.count;
  const double whole_quotient = count == 0 ? 0 : static_cast<double>(whole_product / count);
  return {
      nearest(
          got, m2,
          {{within,
            "two parts with different means vary between them too: add (mean_b - mean_a)^2 n_a n_b "
            "/ n"},
           {a.m2 + n_a * (a.mean - mean) * (a.mean - mean) +  //
                b.m2 + n_b * (b.mean - mean) * (b.mean - mean),
            "both parts were measured from the merged mean, which is rounded: (mean_b - "
            "mean_a)^2 n_a n_b / n needs no third mean"},
           {within + apart * apart * static_cast<double>(whole_product) / n,
            "the counts were multiplied as 64-bit whole numbers, and overflowed: multiply "
            "doubles"},
           {within + apart * apart * whole_quotient,
            "n_a n_b / n was divided as whole numbers, which cuts it off: divide doubles"},
           {within + apart * apart,
            "the squared distance of the means is not multiplied by its weight n_a n_b / n"},
           {within + std::abs(apart) * n_a * n_b / n, "the distance of the means is squared"},
           {within + apart * apart * n_a * n_b, "n_a n_b is still to be divided by n_a + n_b"}}),
      "a.m2 + b.m2 + (mean_b - mean_a)^2 n_a n_b / n; do the counts multiply beyond 64 bits?",
      empty_part};
}

void expect_merge(const Moments& a, const Moments& b) {
  const auto got = MEASURE(merge, a, b);
  const auto exact = exact_merge(a, b);
  const auto mean = static_cast<double>(exact.mean), m2 = static_cast<double>(exact.m2);
  const std::string because = "a dozen operations, each rounded once";
  expect_that(
      got.value.count == a.count + b.count, fmt::format("{}.count = {}", got.call, got.value.count),
      fmt::format("{}", a.count + b.count), "", "the counts add up, as whole numbers of 64 bits");
  expect_within(got.call + ".mean", got.value.mean, mean,
                16 * eps * std::max(std::abs(a.mean), std::abs(b.mean)), because,
                merged_mean_hints(got.value.mean, a, b, mean));
  // apart is a difference of two means as they are: exact enough in itself.
  expect_within(got.call + ".m2", got.value.m2, m2, 64 * eps * m2, because,
                merged_m2_hints(got.value.m2, a, b, mean, m2));
}

CHECK_CASE("1.5 merging two parts equals adding all values", "[1.5][main][points:5]") {
  Rng rng = check_rng();
  for (int i = 0; i < 5; ++i) {
    expect_merge({2 + rng() % 100, uniform(rng, -9, 9), uniform(rng, 0, 99)},
                 {2 + rng() % 100, uniform(rng, -9, 9), uniform(rng, 0, 99)});
  }
  expect_merge({1, uniform(rng, -9, 9), 0}, {1, uniform(rng, -9, 9), 0});
}

CHECK_CASE("1.5 parts of real data merge to the whole", "[1.5][points:2][needs:1.4]") {
  Rng rng = check_rng();
  for (const double offset : {0.0, 1e6}) {
    const auto x = shifted_pattern(rng, offset, 1000);
    std::vector<std::uint64_t> sizes{0, 1, rng() % 200, 0, 300, 2};
    sizes.push_back(1000 - std::accumulate(sizes.begin(), sizes.end(), std::uint64_t{0}));
    const auto exact = exact_moments(x);
    const auto got = MEASURE(merge_parts, x, sizes);
    expect_moments(
        got.call, got.value, exact, two_pass_floor(1000), one_pass_floor(exact), because_one_pass,
        {{}, "weigh the means by the counts: (n_a mean_a + n_b mean_b) / (n_a + n_b)", empty_part},
        {{},
         "add the variation between the parts, (mean_b - mean_a)^2 n_a n_b / n, to m2",
         empty_part});
  }
}

CHECK_CASE("1.5 merging with an empty part changes nothing", "[1.5][edge][points:3]") {
  Rng rng = check_rng();
  const Moments some{2 + rng() % 100, uniform(rng, -9, 9), uniform(rng, 0, 99)};
  expect_merge(some, {});
  expect_merge({}, some);
  const auto nothing = MEASURE(merge, {}, {});
  expect_nothing(nothing.call, nothing.value, "two empty parts merge to an empty one", empty_part);
}

CHECK_CASE("1.5 merging very unequal and very long parts", "[1.5][edge][points:4]") {
  Rng rng = check_rng();
  const double m = uniform(rng, 1, 2);
  const std::uint64_t billion = 1'000'000'000, trillion = billion * 1000;
  expect_merge({billion, m, 5}, {trillion, 2 * m, 7});  // the counts multiply to 1e21 > 2^64
  expect_merge({billion, m, 0}, {1, 3 * m, 0});
  expect_merge({1, 3 * m, 0}, {billion, m, 0});
  expect_merge({billion, 1e9, 100}, {3, 1e9 + 2, 0.5});  // the merged mean is rounded to 1e9
  expect_merge({trillion, m, 1e12}, {1000, m + 1e-7, 1000});
  expect_merge({billion / 2, 1e9, 1}, {billion / 2, 1e9 + 2, 1});
  expect_merge({trillion * 1000, 10, 2.25e16}, {7, 0, 0});
  // Counts that no double holds.
  const std::uint64_t beyond = (std::uint64_t{1} << 53) + 1 + 2 * (rng() % 1000);
  expect_merge({beyond, m, 5}, {2 * (1 + rng() % 1000), -m, 7});
  expect_merge({2 * (1 + rng() % 1000), -m, 7}, {beyond, m, 5});
  expect_merge({(std::uint64_t{1} << 61) + beyond, m, 5}, {std::uint64_t{1} << 60, 3 * m, 7});
}

}  // namespace
}  // namespace mc::checks
