// Task 2.6: how many samples; and how the refusals of this lab are worded.

#include <cmath>
#include <utility>

#include "checks/independent/functions.hpp"
#include "checks/support/catch.hpp"
#include "checks/support/domain.hpp"
#include "checks/support/exact.hpp"
#include "checks/support/refusals.hpp"

namespace mc::checks {
namespace {

struct Plan {
  Estimate pilot;
  double target;
};

void judge_plans(const std::vector<Plan>& plans) {
  Results samples;
  for (const auto& [pilot, target] : plans) {
    const auto got = MEASURE(samples_for, pilot, target);
    const Exact ratio = Exact(pilot.standard_error) / Exact(target);
    const double n = static_cast<double>(pilot.n), plain = static_cast<double>(ratio);
    const double exact = static_cast<double>(ratio * ratio * Exact(n)), slack = 8 * eps * exact;
    // The quotient may have gathered 8 roundings. One too many is accepted, but never one too few.
    const bool is_huge = slack > 0.01;
    const double fewest = is_huge ? exact : std::max(1.0, std::ceil(exact - slack));
    const auto value = static_cast<double>(got.value);
    const bool is_one_more = value == fewest + 1;
    samples.add(got.call, is_one_more ? fewest : value, fewest, slack + is_huge,
                [=]() -> std::vector<Suspect> {
                  const std::string up = "this many do not quite do it: round up";
                  return {{std::floor(exact), up},
                          {std::round(exact), up},
                          {std::ceil(n * plain),
                           "half the error costs four times the samples: square the ratio"},
                          {std::ceil(plain * plain),
                           "the pilot's standard error is that of n samples: times n"},
                          {std::ceil(exact) - n, "all of them are asked for, not how many more"},
                          {std::ceil(n / plain / plain),
                           "the ratio is upside down: a smaller target costs more"},
                          {std::ceil(n * n * plain * plain),
                           "s is standard_error · sqrt(n), not standard_error · n"}};
                });
  }
  samples.expect("the error falls as 1 / sqrt(n)", "n (standard error / target)^2, rounded up");
}

CHECK_CASE("2.6 the samples that bring the error down", "[2.6][points:5][main]") {
  Rng rng = check_rng();
  std::vector<Plan> plans;
  for (int i = 0; i < 10; ++i) {
    const Estimate pilot{uniform(rng, -9, 9), uniform(rng, 0.01, 1), 1000 + rng() % 100000};
    plans.push_back({pilot, pilot.standard_error / uniform(rng, 2, 5)});
  }
  // (3/2)^2 n, n = 4k + 1: a quarter more than a whole number, which rounding to the nearest loses.
  const double target = uniform(rng, 0.01, 1);
  plans.push_back({{uniform(rng, -9, 9), 1.5 * target, 4 * (250 + rng() % 10000) + 1}, target});
  plans.push_back({{1, 0.25, 1000}, 0.125});  // 4000 exactly
  judge_plans(plans);
  plans = {{{1, 0.1, 1000}, 0.7},                   // fewer than the pilot had
           {{1, 0.5, 5}, 1},                        // 1.25, so two
           {{1, 0.5, 4}, 1},                        // one
           {{1, 0.5, 1000000}, 1e-4},               // 2.5e13
           {{-5, 3e170, 17}, 1e169},                // squares that overflow, one by one
           {{-5, 3e-170, 17}, 1e-170},              // and that are 0
           {{1, 0.5, std::uint64_t{1} << 62}, 1}};  // most pilots have fewer
  for (int i = 0; i < 5; ++i) {
    plans.push_back({{1, uniform(rng, 0.5, 50), rng() >> 24}, uniform(rng, 0.5, 1)});
  }
  judge_plans(plans);
}

CHECK_CASE("2.6 at least one sample and at most 64 bits", "[2.6][points:1][edge]") {
  judge_plans({{{1, 1, 1000}, 1e-8}});  // 1e19 fits into 64 bits, but not with a sign
  for (const auto& [error, target] : {std::pair{1e-9, 1.0}, {0.0, 0.1}, {1.0, domain::infinity}}) {
    const auto got = MEASURE(samples_for, {1, error, 100}, target);
    expect_that(got.value == 1, fmt::format("{} = {}", got.call, got.value), "1",
                "the target is met already, but without a sample there is no estimate",
                "at least 1");
  }
}

std::vector<InvalidCall> invalid_plans() {
  std::vector<InvalidCall> calls;
  for (const double target : {-0.1, 0.0, nan, -domain::infinity}) {
    calls.push_back({MEASURE_OUTCOME(samples_for, {1, 0.5, 100}, target), "target|target_error",
                     "a target is positive"});
  }
  calls.push_back({MEASURE_OUTCOME(samples_for, {1, nan, 1}, 0.1), "pilot",
                   "a pilot of one sample has no standard error"});
  calls.push_back({MEASURE_OUTCOME(samples_for, {0, 0.5, 0}, 0.1), "pilot",
                   "a pilot without samples has no standard error"});
  for (const double error : {1e3, 1.5e4, domain::infinity}) {  // 2e19, and more
    const std::uint64_t n = error == 1e3 ? 20 : 1'000'000;
    calls.push_back({MEASURE_OUTCOME(samples_for, {1, error, n}, 1e-6),
                     "target|target_error|pilot|samples", "the answer does not fit into 64 bits"});
  }
  return calls;
}

CHECK_CASE("2.6 pilots and targets that say nothing are refused", "[2.6][points:1][edge]") {
  expect_refused(invalid_plans());
}

CHECK_CASE("2.6 every refusal of this lab names its argument", "[2.6][points:1][edge]") {
  std::vector<InvalidCall> calls = invalid_plans();
  const Function g{exponential, 0, 1, 0};
  const std::string because = "who reads it has more than one argument to look at";
  for (const auto& [call, argument] :
       {std::pair{MEASURE_OUTCOME(estimates, g, 0, 1, 1), "n"},
        {MEASURE_OUTCOME(sample_exponential, {0.5}, -1.0), "rate"},
        {MEASURE_OUTCOME(pdf_exponential, {0.5}, -1.0), "rate"},
        {MEASURE_OUTCOME(sample_power, {0.5}, -2.0), "a"},
        {MEASURE_OUTCOME(pdf_power, {0.5}, -2.0), "a"},
        {MEASURE_OUTCOME(importance_estimates, g, {by_uniform, 0}, 0, 1, 1), "n"},
        {MEASURE_OUTCOME(confidence_interval, {1, 0.1, 100}, 1.5), "level"},
        {MEASURE_OUTCOME(irradiance_area, {}, 0, 1, 1), "n"},
        {MEASURE_OUTCOME(irradiance_hemisphere, {}, 0, 1, 1), "n"}}) {
    calls.push_back({call, argument, because});
  }
  expect_argument_named(calls);
}

}  // namespace
}  // namespace mc::checks
