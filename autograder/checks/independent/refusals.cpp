// What the functions of lab 2 refuse, one table per task: the "throws:" lines of the header.

#include "checks/independent/functions.hpp"

namespace mc::checks {
namespace {

CHECK_CASE("2.2 n = 0 is refused", "[2.2][points:1][edge]") {
  expect_refused({{MEASURE_OUTCOME(estimates, {exponential, 0, 1, 0}, 0, 1, 1), "n", no_mean}});
}

CHECK_CASE("2.3 parameters without a density are refused", "[2.3][points:2][edge]") {
  std::vector<InvalidCall> calls;
  for (const double rate : {-1.0, 0.0, -1e-300, nan, -infinity}) {
    for (const double u : {0.5, 0.0}) {  // 0 is the sample for any rate
      calls.push_back(
          {MEASURE_OUTCOME(sample_exponential, {u}, rate), "rate", "a rate is positive"});
    }
    for (const double x : {0.5, -2.0}) {  // the density is 0 for any rate
      calls.push_back({MEASURE_OUTCOME(pdf_exponential, {x}, rate), "rate", "a rate is positive"});
    }
  }
  const std::string because = "x^a has a finite integral over [0, 1] only for a > -1";
  for (const double a : {-2.0, -1.0, -1 - eps, nan, -infinity}) {
    for (const double x : {0.5, 0.0, -2.0, 2.0}) {
      if (x >= 0 && x < 1) calls.push_back({MEASURE_OUTCOME(sample_power, {x}, a), "a", because});
      calls.push_back({MEASURE_OUTCOME(pdf_power, {x}, a), "a", because});
    }
  }
  expect_refused(calls);
}

CHECK_CASE("2.4 n = 0 is refused", "[2.4][points:1][edge]") {
  expect_refused(
      {{MEASURE_OUTCOME(importance_estimates, {exponential, 0, 1, 0}, {by_uniform, 0}, 0, 1, 1),
        "n", no_mean}});
}

CHECK_CASE("2.5 levels outside 0 to 1 are refused", "[2.5][points:1][edge]") {
  std::vector<InvalidCall> calls;
  for (const double level : {1.5, -0.5, 1.0, 0.0, nan, infinity, -infinity}) {
    for (const double error : {0.1, 0.0}) {
      calls.push_back({MEASURE_OUTCOME(confidence_interval, {1, error, 100}, level), "level",
                       "a level is a probability between 0 and 1"});
    }
  }
  expect_refused(calls);
}

std::vector<InvalidCall> invalid_plans() {
  std::vector<InvalidCall> calls;
  for (const double target : {-0.1, 0.0, nan, -infinity}) {
    for (const double error : {0.5, 0.0}) {
      calls.push_back({MEASURE_OUTCOME(samples_for, {1, error, 100}, target), "target|target_error",
                       "a target is positive"});
    }
  }
  for (const double target : {0.1, infinity}) {
    calls.push_back({MEASURE_OUTCOME(samples_for, {1, nan, 1}, target), "pilot",
                     "a pilot of one sample has no standard error"});
    calls.push_back({MEASURE_OUTCOME(samples_for, {0, 0.5, 0}, target), "pilot",
                     "a pilot without samples has no standard error"});
  }
  // 2^64, the first number that does not fit; 2e19; infinity.
  for (const auto& [n, ratio] : {std::pair{1u, 0x1p32}, {20u, 1e9}, {1u << 20, infinity}}) {
    calls.push_back({MEASURE_OUTCOME(samples_for, {1, ratio, n}, 1),
                     "target|target_error|pilot|samples",
                     "the number of samples does not fit into 64 bits"});
  }
  return calls;
}

CHECK_CASE("2.6 unusable pilots and targets are refused", "[2.6][points:1][edge]") {
  expect_refused(invalid_plans());
}

CHECK_CASE("2.6 every refusal of this lab names its argument", "[2.6][points:1][edge]") {
  std::vector<InvalidCall> calls = invalid_plans();
  const Function g{exponential, 0, 1, 0};
  const std::string because = "the function has more than one argument";
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
