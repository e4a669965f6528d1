// Task 2.2, as far as it can be judged exactly: by the points and values that each estimate saw.

#include <fmt/format.h>

#include "checks/independent/traces.hpp"
#include "checks/support/catch.hpp"

namespace mc::checks {
namespace {

CHECK_CASE("2.2 the estimate is the mean of its values", "[2.2][points:4][needs:2.1][main]") {
  Rng rng = check_rng();
  for (const unsigned g : {exponential, product, five}) {
    for (const std::uint64_t n : {1000u, 10u, 2u}) {
      const Traced seen(fresh(g, rng), n, rng);
      expect_mean_of(seen.call(), seen.estimates()[0].value, seen.values());
    }
  }
  // Of both signs, with the mean 0: sizes that a guard for positive values would change.
  const Traced signs({normal, 0, uniform(rng, 0.5, 4), 0}, 1000, rng);
  double without_negative = 0, of_sizes = 0;
  for (const double value : signs.values()) {
    without_negative += std::max(value, 0.0) / static_cast<double>(signs.evaluations());
    of_sizes += std::abs(value) / static_cast<double>(signs.evaluations());
  }
  expect_mean_of(signs.call(), signs.estimates()[0].value, signs.values(),
                 {{without_negative, "values below 0 count, too"},
                  {of_sizes, "values below 0 count as what they are, not by their size"}});
}

CHECK_CASE("2.2 exactly n evaluations inside the unit cube", "[2.2][points:4][needs:2.1]") {
  Rng rng = check_rng();
  for (const unsigned g : {exponential, product, five}) {
    for (const std::uint64_t n : {100u, 1000u, 3u, 2u}) {
      const Traced seen(fresh(g, rng), n, rng);
      const std::size_t evaluations = seen.evaluations();
      expect_that(evaluations == n,
                  fmt::format("{} evaluated g {} times", seen.call(), evaluations),
                  fmt::format("{}", n), "n is what the caller pays for",
                  evaluations < n ? "one is missing: does the loop begin at 1?"
                                  : "one too many: does the loop end at i <= n?");
      const std::uint64_t counted = seen.estimates()[0].n;
      expect_that(counted == n, fmt::format("{}: n = {}", seen.call(), counted),
                  fmt::format("{}", n), "the n of an Estimate counts evaluations",
                  "every sample counts once");
    }
  }
}

CHECK_CASE("2.2 the standard error is s over root n", "[2.2][points:5][needs:2.1]") {
  Rng rng = check_rng();
  for (const unsigned g : {exponential, product, normal}) {
    for (const std::uint64_t n : {1000u, 10u, 3u, 2u}) {
      const Traced seen(fresh(g, rng), n, rng);
      expect_standard_error(seen.call(), seen.estimates()[0].standard_error, seen.values());
    }
  }
  Function far = fresh(exponential, rng);
  far.offset = uniform(rng, 1e9, 2e9);
  const Traced large(far, 1000, rng);
  expect_standard_error(large.call(), large.estimates()[0].standard_error, large.values());
}

CHECK_CASE("2.2 a constant has the standard error 0", "[2.2][points:1][needs:2.1]") {
  Rng rng = check_rng();
  const std::uint64_t n = 1000;
  // Lab 1's variances of a constant are at most (n eps c)^2.
  const auto expect_zero = [&](const std::string& call, double standard_error, double c) {
    expect_within(call + ".standard_error", standard_error, 0,
                  std::sqrt(static_cast<double>(n)) * eps * c,
                  "a constant does not vary: lab 1's variances leave at most (n eps c)^2 of it",
                  {{},
                   "which variance is this? E{X^2} - E{X}^2 leaves more",
                   "the root of a variance below 0 is NaN: E{X^2} - E{X}^2 may be that"});
  };
  const double one = uniform(rng, 0.1, 1e6);
  const Traced seen({constant, 0, one, 0}, n, rng);
  expect_zero(seen.call(), seen.estimates()[0].standard_error, one);
  // More of them, since a difference of roundings may come to 0 by chance.
  std::vector<Function> constants;
  std::vector<std::uint64_t> seeds;
  for (int i = 0; i < 50; ++i) {
    constants.push_back({constant, 0, uniform(rng, 0.1, 1e6), 0});
    seeds.push_back(rng());
  }
  const auto measured = MEASURE(estimates_in_turn, constants, n, seeds);
  const auto& estimates = measured.exactly(constants.size(), any_number);
  for (std::size_t i = 0; i < constants.size(); ++i) {
    expect_zero(
        fmt::format("estimates_in_turn({{{}}}, {}, {{{}}})", shown(constants[i]), n, seeds[i]),
        estimates[i].standard_error, constants[i].scale);
  }
}

CHECK_CASE("2.2 one sample has no standard error", "[2.2][points:1][edge][needs:2.1]") {
  Rng rng = check_rng();
  const Traced one(fresh(product, rng), 1, rng);
  expect_nan(one.call() + ".standard_error", one.estimates()[0].standard_error,
             "one value says nothing about how values vary");
}

CHECK_CASE("2.2 no samples are refused", "[2.2][points:1][edge]") {
  expect_invalid_argument(MEASURE_OUTCOME(estimates, {exponential, 0, 1, 0}, 0, 1, 1), "",
                          "the mean of nothing is no estimate");
}

CHECK_CASE("2.2 an estimate depends on its generator alone", "[2.2][points:1][edge][needs:2.1]") {
  Rng rng = check_rng();
  const Function of_five = fresh(five, rng), of_one = fresh(exponential, rng);
  const std::uint64_t n = 100, seed = rng(), another = rng();
  const auto measured =
      MEASURE(estimates_in_turn, {of_five, of_one, of_five}, n, {seed, another, seed});
  const auto& turns = measured.exactly(3);
  const auto measured_alone = MEASURE(estimates_in_turn, {of_one}, n, {another});
  const auto& alone = measured_alone.exactly(1);
  const std::string because = "the generator that it is given is its only source of randomness";
  const std::string hint = "no generator of your own, no clock, nothing static";
  expect_that(turns[0].value == turns[2].value,
              fmt::format("{}: {}, and from an equal generator {}", measured.call, turns[0].value,
                          turns[2].value),
              "the same estimate", because, hint);
  expect_that(turns[1].value == alone[0].value,
              fmt::format("{}: {} after another integrand; {} without it", measured.call,
                          turns[1].value, alone[0].value),
              "the same estimate", because, hint);
}

}  // namespace
}  // namespace mc::checks
