// Speed in a report: told, never graded.

#include <nlohmann/json.hpp>

#include "checks/support/catch.hpp"
#include "checks/support/speed_data.hpp"
#include "grader/reports/report.hpp"

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
                          const ForGradescope& wanted = {.leaderboard = true}) {
  Verdict verdict;
  verdict.labs.push_back(lab);
  return nlohmann::json::parse(report_json(verdict, wanted));
}

TEST_CASE("a lab is as many times as fast as the geometric mean of its tasks") {
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

TEST_CASE("speed is in the results and not in the score") {
  LabVerdict lab = passed_lab();
  lab.speed = {task(0.5, 1.0)};
  const auto results = results_of(lab);
  CHECK(results["score"] == 3);
  REQUIRE(results["leaderboard"].size() == 1);
  CHECK(results["leaderboard"][0]["value"] == 2);
  // The class sees it: it is there only where it is asked for.
  CHECK_FALSE(results_of(lab, {}).contains("leaderboard"));
  CHECK(results["extra_data"]["speed"][0]["name"] == "2.8 uniforms");
}

TEST_CASE("time wasted before the first round makes no round shorter") {
  int runs = 0;
  const checks::Rounds run = [&](std::uint64_t rounds) -> std::optional<double> {
    const double noise = runs++ % 2 == 0 ? 1e-4 : 0;  // it hides a microsecond
    return 0.03 + noise + 1e-6 * static_cast<double>(rounds);
  };
  auto rounds = checks::rounds_of(run, 0.025);
  REQUIRE(rounds);
  const auto seconds = checks::seconds_by_difference(run, *rounds);
  REQUIRE(seconds);
  CHECK(*seconds == Approx(1e-6).epsilon(0.02));
}

TEST_CASE("what was wrong when it was timed has no speed, and says why") {
  LabVerdict lab = passed_lab();
  Speed forged = task(0, {});
  forged.wrong = "0.1 with seed 7, which gives 0.2 when judged";
  lab.speed = {forged};
  CHECK_FALSE(lab.times_the_reference());
  CHECK(report_speed(lab).find("wrong when timed: 0.1 with seed 7") != std::string::npos);
  CHECK(report_speed(lab).find("0 ns") == std::string::npos);
  const auto results = results_of(lab);
  CHECK_FALSE(results.contains("leaderboard"));
  CHECK(results["extra_data"]["speed"][0]["wrong"] == forged.wrong);
  CHECK_FALSE(results["extra_data"]["speed"][0].contains("nanoseconds"));
  lab.speed = {forged, task(1, 2.0)};
  CHECK(*lab.times_the_reference() == Approx(2));
}

}  // namespace
}  // namespace mc::grader
