// Speed in a report: shown, never graded.

#include <set>
#include <string>

#include <nlohmann/json.hpp>

#include "checks/support/catch.hpp"
#include "grader/checkout/labs.hpp"
#include "grader/checkout/layout.hpp"
#include "grader/judging/judge.hpp"
#include "grader/judging/speed.hpp"
#include "grader/reports/report.hpp"
#include "grader/submission/build.hpp"
#include "grader/submission/submission.hpp"
#include "measurements/support/speed_data.hpp"

namespace mc::grader {
namespace {

LabVerdict passed_lab() {
  LabVerdict lab;
  lab.lab = {2, "independent", "2-independent", {}};
  CheckResult result;
  result.check = {"2.8 a span of any size is filled", "2.8", {}, 3, false};
  result.status = Status::passed;
  lab.checks.push_back(result);
  return lab;
}

Speed task(double nanoseconds, std::optional<double> reference) {
  Speed speed;
  speed.name = "2.8 uniforms";
  speed.nanoseconds = nanoseconds;
  speed.reference = reference;
  return speed;
}

nlohmann::json results_of(const LabVerdict& lab,
                          const GradescopeOptions& wanted = {.leaderboard = true}) {
  Verdict verdict;
  verdict.labs.push_back(lab);
  return nlohmann::json::parse(report_json(verdict, wanted));
}

TEST_CASE("a lab's speed-up is the geometric mean over its tasks") {
  LabVerdict lab = passed_lab();
  lab.speed = {task(1, 4.0), task(1, 1.0)};
  REQUIRE(lab.times_the_reference());
  CHECK(*lab.times_the_reference() == Approx(2));
}

TEST_CASE("without a reference nothing is compared") {
  LabVerdict lab = passed_lab();
  lab.speed = {task(1, {})};
  CHECK_FALSE(lab.times_the_reference());
  CHECK_FALSE(results_of(lab).contains("leaderboard"));
  CHECK(report_speed(lab).find("1 ns") != std::string::npos);
}

TEST_CASE("without the reference, its time is shown as an estimate") {
  LabVerdict lab = passed_lab();
  lab.speed = {task(1, 4.0)};
  lab.speed[0].is_estimate = true;
  lab.speed[0].addition = 0.5;
  const std::string report = report_speed(lab);
  CHECK(report.find("1 ns   (the reference: about 4 ns)") != std::string::npos);
  CHECK(report.find("a running sum, to compare") != std::string::npos);
  CHECK(report.find("0.5 ns\n") != std::string::npos);
  CHECK(report.find("about 4.0 times as fast as the reference") != std::string::npos);
  lab.speed = {task(600, 1.0)};
  CHECK(report_speed(lab).find("about 600 times slower than the reference") != std::string::npos);
}

// Not in --quick: it times every speed task.
TEST_CASE("each speed task has a ratio, stored with its lab", "[.numbers]") {
  const Layout layout = read_layout();
  const auto labs = find_labs(layout);
  const Submission solutions = open_submission(labs, layout.solutions());
  std::size_t found = 0;
  for (const Lab& lab : labs) {
    CAPTURE(lab.name);
    const BuildResult built = build_program(layout, lab, solutions);
    REQUIRE(built.program);
    std::set<std::string> tasks, measured;
    for (const Check& check : expected_checks(layout, lab)) tasks.insert(check.task);
    for (const protocol::Row& row : speed_rows(layout, lab, *built.program, tasks)) {
      if (row.kind == "speed") measured.insert(row.what);
    }
    std::set<std::string> kept;
    for (const auto& [name, ratio] : kept_ratios(ratios_file(layout, lab))) {
      kept.insert(name);
      CHECK(ratio > 0);
    }
    CHECK(kept == measured);
    found += kept.size();
  }
  CHECK(found > 6);
}

TEST_CASE("speed is in the results and not in the score") {
  LabVerdict lab = passed_lab();
  lab.speed = {task(0.5, 1.0)};
  const auto results = results_of(lab);
  CHECK(results["score"] == 3);
  REQUIRE(results["leaderboard"].size() == 1);
  CHECK(results["leaderboard"][0]["value"] == 2);
  // The class sees it, so it is present only on request.
  CHECK_FALSE(results_of(lab, {}).contains("leaderboard"));
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
