// Speed in a report: shown, never graded.

#include <nlohmann/json.hpp>

#include "judge/judging/judge.hpp"
#include "judge/judging/speed.hpp"
#include "judge/reports/report.hpp"
#include "measurements/support/speed_data.hpp"
#include "tests/submissions.hpp"

namespace mc::grader {
namespace {

using protocol::Row;

LabVerdict passed_lab(const std::vector<Speed>& speed) {
  LabVerdict lab =
      tests::verdict_of({tests::result_of("2.8 a span of any size is filled", Status::passed)});
  lab.speed = speed;
  return lab;
}

/// Rows of one task, timed in turn with plain code.
std::vector<Row> in_turn(const std::string& task, const std::vector<double>& ns,
                         const std::vector<double>& plain) {
  std::vector<Row> rows;
  for (std::size_t i = 0; i < ns.size(); ++i) {
    rows.push_back({.task = task, .n = 4096, .ns = ns[i]});
    rows.push_back({.method = "plain", .task = task, .n = 4096, .ns = plain[i]});
  }
  return rows;
}

TEST_CASE("a row survives its line, and a truncated line is left out") {
  const Row row{"halton", "Sobol', \"scrambled\"", "5.8", "smooth 2D", 2, 64, 0.25, 1.5};
  const std::string line = protocol::line_of(row);
  const auto read = protocol::row_in(line);
  REQUIRE(read);
  CHECK(read->method == row.method);
  CHECK(protocol::line_of(*read) == line);
  CHECK_FALSE(protocol::row_in(line.substr(0, line.rfind(','))));
  CHECK_FALSE(protocol::row_in(protocol::rows_header));
}

TEST_CASE("a speed task is compared with plain code by the median of ratios") {
  auto rows = in_turn("5.8 points", {1, 2, 4}, {8, 12, 40});  // ratios 8, 6, 10
  rows.push_back({.task = "5.8 points", .integrand = "exp(x + y)", .n = 1024, .rmse = 2e-5});
  const auto missing = in_turn("5.2 others", {3}, {protocol::unknown});
  rows.insert(rows.end(), missing.begin(), missing.end());
  const auto speed = speed_in(rows);
  REQUIRE(speed.size() == 2);
  CHECK(speed[0].nanoseconds == 2);
  CHECK(speed[0].plain == 12.0);
  CHECK(speed[0].noise == Approx(0.25));  // 8 ± 2
  CHECK(speed[0].error == 2e-5);
  CHECK(speed[1].nanoseconds == 3);
  CHECK_FALSE(speed[1].plain);
  tests::check_contains(report_speed(passed_lab(speed)),
                        {"2 ns   (plain code: 12 ns)", "RMSE of 1024 on exp(x + y)", "3 ns\n",
                         "6.0 times as fast as plain code, ± 25 %; speed is not graded."});
}

TEST_CASE("of several speed tasks the factor is their geometric mean, and says so") {
  const LabVerdict lab = passed_lab({{.name = "a", .nanoseconds = 4, .plain = 1.0},
                                     {.name = "b", .nanoseconds = 9, .plain = 1.0}});
  REQUIRE(lab.times_plain());
  CHECK(*lab.times_plain() == Approx(1. / 6));
  CHECK(tests::contains(report_speed(lab), "6.0 times slower than plain code (geometric mean)"));
  CHECK_FALSE(passed_lab({{.name = "a", .nanoseconds = 1}}).times_plain());
}

TEST_CASE("each speed task has a plain counterpart", "[.slow]") {
  const Layout layout = read_layout();
  const auto labs = find_labs(layout);
  const Submission solutions = open_submission(labs, layout.solutions());
  for (const Lab& lab : labs) {
    CAPTURE(lab.name);
    const BuildResult built = build_program(layout, lab, solutions);
    REQUIRE(built.program);
    std::set<std::string> tasks;
    for (const Check& check : expected_checks(layout, lab)) tasks.insert(check.task);
    const auto speed = speed_in(speed_rows(layout, lab, *built.program, tasks));
    CHECK_FALSE(speed.empty());
    for (const Speed& one : speed) {
      CAPTURE(one.name);
      CHECK(one.plain);
    }
  }
}

TEST_CASE("speed is in the results and not in the score") {
  Verdict verdict;
  verdict.labs.push_back(passed_lab({{.name = "2.8 uniforms", .nanoseconds = 0.5, .plain = 1.0}}));
  const auto results = nlohmann::json::parse(results_json(verdict));
  CHECK(results["score"] == 5);
  CHECK(results["extra_data"]["speed"][0]["name"] == "2.8 uniforms");
}

TEST_CASE("time lost before the first round does not shorten later rounds") {
  int runs = 0;
  const measurements::Rounds run = [&](std::uint64_t rounds) {
    const double noise = runs++ % 2 == 0 ? 1e-4 : 0;  // it hides a microsecond
    return 0.03 + noise + 1e-6 * static_cast<double>(rounds);
  };
  auto rounds = measurements::rounds_for(run, 0.025);
  CHECK(measurements::seconds_by_difference(run, rounds) == Approx(1e-6).epsilon(0.02));
}

}  // namespace
}  // namespace mc::grader
