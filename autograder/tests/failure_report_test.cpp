// The notation of calls and numbers in reports, and what a comparison says of wrong values.
#include <algorithm>
#include <numeric>

#include "2-independent/functions.hpp"
#include "6-sampler/experiments.hpp"
#include "checks/support/compare.hpp"
#include "checks/support/validation.hpp"
#include "judge/reports/report.hpp"
#include "tests/submissions.hpp"

namespace mc::tests::report {

using checks::without_empty_signs;
using experiments::spelled;
using experiments::spelled_call;
using experiments::Spelling;
using experiments::Step;
using Values = std::vector<double>;

TEST_CASE("only meaningless signs are left out") {
  CHECK(without_empty_signs("x = -nan, y = -0") == "x = nan, y = 0");
  CHECK(without_empty_signs("{-0, -nan}, [-0]") == "{0, nan}, [0]");
  CHECK(without_empty_signs("is -0.") == "is 0.");
  for (const char* kept : {"-0.5", "1e-05", "2^-0", "-0x1p-3", "-nanny", "a-0", "-01"}) {
    CHECK(without_empty_signs(kept) == kept);
  }
}

TEST_CASE("calls of a sampler are written as in student code") {
  std::vector<Step> steps{{0, 12, 7}, {1}, {2}, {3}};
  CHECK(spelled_call(Spelling{}, "play", "sobol", steps) ==
        "sobol: generate(12, 7); next(); next2(); advance()");
  for (int i = 0; i < 41; ++i) steps.push_back({1});
  CHECK(
      spelled_call(Spelling{}, "play_two", "halton", steps) ==
      "two of halton: generate(12, 7); next(); next2(); advance(); next(); next(); next(); next(); "
      "… 37 more calls");
  CHECK(spelled_call(Spelling{}, "columns", "sobol", 64, std::vector<std::uint64_t>{5},
                     std::vector<unsigned>{1, 2}) ==
        "sobol: generate(64, 5), then for each sample next(); next2()");
  CHECK(
      spelled_call(Spelling{}, "estimates", "sobol", "disk_light", std::vector<double>{1, 2, 3},
                   2.0, -0.5, 64, std::vector<std::uint64_t>{5, 6}) ==
      "integrate(2 * disk_light{radius = 1, height = 2, offset = 3} - 0.5, sobol, 64, seed), with "
      "each of 2 seeds");
}

TEST_CASE("integrands and densities are written as formulas") {
  CHECK(spelled(experiments::Function{4, 0.5, 2, -1}) == "2 * x^0.5 - 1");
  CHECK(spelled(experiments::Function{1, 0, 1, 0}) == "exp(x)");
  CHECK(spelled(experiments::Function{3, 0.25, 1, 3}) == "(1 if x < 0.25, else 0) + 3");
  CHECK(spelled(experiments::Sampling{2, 3}) == "p(x) = 3 exp(-3 x) for x >= 0");
}

TEST_CASE("a later failure of a task keeps its result and its diagnosis") {
  std::vector<CheckResult> results;
  const std::string call = "measured  mean({1.25, 2.5, 3.75, 4.125, 5.0625, … (12 values)}) = ";
  for (const std::string& report :
       {call + "7\nexpected  3\nlikely    first", call + "8\nlikely    second",
        std::string("measured  mean({1}) = 9\nlikely    second")}) {
    results.push_back(result_of("1.1 a check", Status::failed, report));
  }
  const std::string text = report_lab(verdict_of(results), {}, {});
  check_contains(text, {"also      mean({…}) = 8", "also      mean({1}) = 9"});
  CHECK(times(text, "likely    second") == 1);
}

/// Of values that became `got`.
checks::Failure failure_of(const Values& exact, const Values& got) {
  const auto failure =
      checks::difference({"f()", got}, {.exact = exact, .tolerance = {1e-9}, .rule = "no idea"});
  REQUIRE(failure);
  return *failure;
}

TEST_CASE("a comparison says what is true of the wrong values") {
  Values exact(50);
  std::iota(exact.begin(), exact.end(), 0.5);
  const auto changed = [&](auto change) {
    Values got = exact;
    for (std::size_t i = 0; i < got.size(); ++i) change(got[i], i);
    return got;
  };
  const auto capped = failure_of(exact, changed([](double& x, auto) { x = std::min(x, 40.25); }));
  CHECK(capped.likely.text == "no value is above 40.25: something limits the values");
  CHECK(contains(capped.measured, "the last 10 of 50 values are wrong, from value 40 on"));
  const auto raised = failure_of(exact, changed([](double& x, auto) { x = std::max(x, 9.75); }));
  CHECK(raised.likely.text == "no value is below 9.75: something limits the values");

  // One wrong value is not a limit, and neither are values that jump over it.
  CHECK(failure_of(exact, changed([](double& x, auto i) { x = i == 7 ? 3 : x; })).rule ==
        "no idea");
  const auto third = failure_of(exact, changed([](double& x, auto i) { x = i % 3 == 1 ? 5 : x; }));
  CHECK(third.rule == "no idea");
  CHECK(contains(third.measured, "17 of 50 values are wrong: every 3rd, from value 1 on"));
}

}  // namespace mc::tests::report
