// Task 2.6: how many samples; and how the refusals of this lab are worded.

#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "checks/independent/functions.hpp"
#include "checks/support/catch.hpp"
#include "checks/support/exact.hpp"
#include "checks/support/expect.hpp"
#include "checks/support/measure.hpp"

namespace mc::checks {
namespace {

void expect_samples(const Estimate& pilot, double target) {
  const auto got = MEASURE(samples_for, pilot, target);
  const Exact ratio = Exact(pilot.standard_error) / Exact(target);
  const double n = static_cast<double>(pilot.n), plain = static_cast<double>(ratio);
  const double exact = static_cast<double>(ratio * ratio * Exact(n));
  const double samples = static_cast<double>(got.value);
  // Rounded up, where the quotient may have gathered 8 roundings: one too many, but never one
  // too few.
  const bool holds = samples >= exact * (1 - 8 * eps) && samples <= exact * (1 + 8 * eps) + 1;
  const auto about = [&](double suspect) { return std::abs(samples - suspect) <= 1; };
  std::string hint = "n (standard error / target)^2, rounded up";
  if (samples < exact && about(exact)) {
    hint = "this many do not quite do it: round up";
  } else if (about(n * plain)) {
    hint = "half the error costs four times the samples: square the ratio";
  } else if (about(plain * plain)) {
    hint = "the pilot's standard error is that of n samples: times n";
  } else if (about(exact - n)) {
    hint = "all of them are asked for, not how many more";
  } else if (about(n / plain / plain)) {
    hint = "the ratio is upside down: a smaller target costs more";
  } else if (about(n * n * plain * plain)) {
    hint = "s is standard_error · sqrt(n), not standard_error · n";
  }
  expect_that(holds, fmt::format("{} = {}", got.call, got.value),
              fmt::format("{:.17g}, rounded up", exact), "the error falls as 1 / sqrt(n)", hint);
}

CHECK_CASE("2.6 the samples that bring the error down", "[2.6][points:5][main]") {
  Rng rng = check_rng();
  for (int i = 0; i < 10; ++i) {
    const Estimate pilot{uniform(rng, -9, 9), uniform(rng, 0.01, 1), 1000 + rng() % 100000};
    expect_samples(pilot, pilot.standard_error / uniform(rng, 2, 5));
  }
  // (3/2)^2 n, n = 4k + 1: a quarter more than a whole number, which rounding to the nearest loses.
  const double target = uniform(rng, 0.01, 1);
  expect_samples({uniform(rng, -9, 9), 1.5 * target, 4 * (250 + rng() % 10000) + 1}, target);
  expect_samples({1, 0.25, 1000}, 0.125);   // 4000 exactly
  expect_samples({1, 0.1, 1000}, 0.7);      // fewer than the pilot had
  expect_samples({1, 0.5, 1000000}, 1e-4);  // 2.5e13
  expect_samples({-5, 3e150, 17}, 1e149);   // squares that overflow, if taken one by one
}

CHECK_CASE("2.6 at least one sample and at most 64 bits", "[2.6][points:1][edge]") {
  for (const auto& [error, target] : {std::pair{1e-9, 1.0}, {0.0, 0.1}}) {
    const auto got = MEASURE(samples_for, {1, error, 100}, target);
    expect_that(got.value == 1, fmt::format("{} = {}", got.call, got.value), "1",
                "the target is met already, but without a sample there is no estimate",
                "at least 1");
  }
  expect_samples({1, 1, 1000}, 1e-8);  // 1e19 fits into 64 bits, but not with a sign
}

CHECK_CASE("2.6 pilots and targets that say nothing are refused", "[2.6][points:1][edge]") {
  for (const double target : {-0.1, 0.0, nan}) {
    expect_invalid_argument(MEASURE_OUTCOME(samples_for, {1, 0.5, 100}, target), "",
                            "a target is positive");
  }
  expect_invalid_argument(MEASURE_OUTCOME(samples_for, {1, nan, 1}, 0.1), "",
                          "a pilot of one sample has no standard error");
  expect_invalid_argument(MEASURE_OUTCOME(samples_for, {0, 0.5, 0}, 0.1), "",
                          "a pilot without samples has no standard error");
  expect_invalid_argument(MEASURE_OUTCOME(samples_for, {1, 1e6, 1000}, 1e-6), "",
                          "1e27 does not fit into 64 bits");
}

/// Where misuse is refused, the text says which argument was wrong. That it is refused at all is
/// asked by the checks of each task.
void expect_wording(const Call& call, const std::string& argument) {
  const auto& outcome = call.outcome;
  if (outcome.answered && outcome.status == wire::Status::todo) require_value(call);
  if (!outcome.answered || outcome.status != wire::Status::invalid_argument) return;
  expect_invalid_argument(call, argument, "who reads it has more than one argument to look at");
}

CHECK_CASE("2.6 every refusal of this lab names its argument", "[2.6][points:1][edge]") {
  expect_wording(MEASURE_OUTCOME(samples_for, {1, 0.5, 100}, -0.1), "target");
  expect_wording(MEASURE_OUTCOME(samples_for, {1, nan, 1}, 0.1), "pilot");
  expect_wording(MEASURE_OUTCOME(samples_for, {1, 1e6, 1000}, 1e-6), "target|pilot|samples");
  const Function g{exponential, 0, 1, 0};
  const std::pair<Call, std::string> others[] = {
      {MEASURE_OUTCOME(estimates, g, 0, 1, 1), "n"},
      {MEASURE_OUTCOME(sample_exponential, {0.5}, -1.0), "rate"},
      {MEASURE_OUTCOME(sample_power, {0.5}, -2.0), "a"},
      {MEASURE_OUTCOME(importance_estimates, g, {by_uniform, 0}, 0, 1, 1), "n"},
      {MEASURE_OUTCOME(confidence_interval, {1, 0.1, 100}, 1.5), "level"},
      {MEASURE_OUTCOME(irradiance_area, {}, 0, 1, 1), "n"},
      {MEASURE_OUTCOME(irradiance_hemisphere, {}, 0, 1, 1), "n"}};
  for (const auto& [call, argument] : others) {
    if (call.outcome.status != wire::Status::todo) expect_wording(call, argument);
  }
  pass();
}

}  // namespace
}  // namespace mc::checks
