// Speed in a report: shown, never graded.

#include <set>

#include <nlohmann/json.hpp>

#include "grader/judging/judge.hpp"
#include "grader/judging/speed.hpp"
#include "grader/reports/report.hpp"
#include "measurements/support/speed_data.hpp"
#include "tests/submissions.hpp"

namespace mc::grader {
namespace {

Speed task(double nanoseconds, std::optional<double> reference, bool is_estimate = false) {
  Speed speed;
  speed.name = "2.8 uniforms";
  speed.nanoseconds = nanoseconds;
  speed.reference = reference;
  speed.is_estimate = is_estimate;
  return speed;
}

LabVerdict passed_lab(const std::vector<Speed>& speed) {
  LabVerdict lab =
      tests::verdict_of({tests::result_of("2.8 a span of any size is filled", Status::passed)});
  lab.speed = speed;
  return lab;
}

nlohmann::json results_of(const LabVerdict& lab) {
  Verdict verdict;
  verdict.labs.push_back(lab);
  return nlohmann::json::parse(results_json(verdict));
}

TEST_CASE("a lab's speed-up is the geometric mean over its tasks") {
  const LabVerdict lab = passed_lab({task(1, 4.0), task(1, 1.0)});
  REQUIRE(lab.times_the_reference());
  CHECK(*lab.times_the_reference() == Approx(2));
}

TEST_CASE("without a reference nothing is compared") {
  const LabVerdict lab = passed_lab({task(1, {})});
  CHECK_FALSE(lab.times_the_reference());
  CHECK(tests::contains(report_speed(lab), "1 ns"));
}

TEST_CASE("without the reference, its time is shown as an estimate") {
  LabVerdict lab = passed_lab({task(1, 4.0, true)});
  lab.speed[0].addition = 0.5;
  tests::check_contains(report_speed(lab),
                        {"1 ns   (the reference: about 4 ns)", "a running sum, to compare",
                         "0.5 ns\n", "about 4.0 times as fast as the reference"});
  CHECK(tests::contains(report_speed(passed_lab({task(600, 1.0)})),
                        "about 600 times slower than the reference"));
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
  const LabVerdict lab = passed_lab({task(0.5, 1.0)});
  const auto results = results_of(lab);
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
