// A grader that judges many submissions leaks no descriptor, and an exception in a worker ends it
// with a message and a status.
#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

#include "checks/support/catch.hpp"
#include "grader/checkout/labs.hpp"
#include "grader/checkout/layout.hpp"
#include "grader/judging/judge.hpp"
#include "grader/pictures/plots.hpp"
#include "grader/submission/build.hpp"
#include "grader/submission/submission.hpp"
#include "sandbox/process.hpp"
#include "tests/hygiene.hpp"
#include "tests/submissions.hpp"
#include "tests/text.hpp"

namespace mc::tests::hygiene {

using namespace grader;

namespace {

struct Labs {
  Layout layout = read_layout();
  std::vector<Lab> labs = find_labs(layout);
  const Lab& lab = find_lab(labs, "variance");
  std::string starter = text_of(layout.starter());

  /// The starter with a different comment.
  Submission submission(const Scratch& place, int number) const {
    place.write("variance.cpp", starter + fmt::format("// {}\n", number));
    return open_submission(labs, place.path());
  }
};

/// The number of submissions with this result.
std::size_t count(const LabVerdict& verdict, Status status) {
  std::size_t found = 0;
  for (const CheckResult& result : verdict.checks) found += result.status == status;
  return found;
}

}  // namespace

TEST_CASE("300 submissions under 64 descriptors", "[.descriptors]") {
  const Labs labs;
  const Scratch place;
  JudgeOptions options;
  options.seed = 1;
  options.only = "1.1";
  std::size_t judged = 0;
  const FewDescriptors few(64);
  const std::size_t before = open_descriptors();
  for (int i = 0; i < 300; ++i) {  // ten of them are compiled, 290 are in the cache
    const BuildResult built = build_program(labs.layout, labs.lab, labs.submission(place, i % 10));
    REQUIRE(built.program);
    const LabVerdict verdict = judge_lab(labs.layout, labs.lab, built, options);
    judged += count(verdict, Status::not_written) == verdict.checks.size();
  }
  CHECK(judged == 300);
  CHECK(open_descriptors() == before);
}

TEST_CASE("plots under 64 descriptors") {
  const Labs labs;
  if (!std::filesystem::exists(labs.layout.measurements(labs.lab.name))) return;  // it is not built
  const Scratch place;
  const FewDescriptors few(64);
  const std::size_t before = open_descriptors();
  for (int i = 0; i < 4; ++i) {
    draw_plots(labs.layout, labs.lab, {labs.submission(place, i % 2)}, "tests");
  }
  CHECK(open_descriptors() == before);
}

TEST_CASE("a plot draws what there is, and states in place what is missing") {
  const Labs labs;
  if (!std::filesystem::exists(labs.layout.measurements(labs.lab.name))) return;  // it is not built
  const Scratch place;
  const auto drawn = [&](const std::string& text, const char* label) {
    Submission submission = labs.submission(place, 0);
    place.write("variance.cpp", text);
    submission.label = label;
    return draw_plots(labs.layout, labs.lab, {submission}, "tests");
  };
  const auto picture = [&](const std::string& name) {
    return read_text(labs.layout.build / "plots" / "tests" / ("variance-" + name + ".svg"));
  };
  const Plots none = drawn(text_of(labs.layout.starter()), "starter");
  CHECK(picture("digits").find("not drawn: ") != std::string::npos);
  CHECK(picture("digits").find("is not written yet") != std::string::npos);
  CHECK(std::any_of(none.remarks.begin(), none.remarks.end(), [](const std::string& remark) {
    return remark.starts_with("starter, digits: 1.") && remark.ends_with(" is not written yet");
  }));

  const std::string text =
      with_change(text_of(labs.layout.starter()), "throw todo(\"1.2\");", "return 1.0 / 12;");
  const Plots some = drawn(text, "anna");
  CHECK(picture("digits").find("not drawn: ") == std::string::npos);
  CHECK_FALSE(some.remarks.empty());
}

TEST_CASE("an exception in a worker reaches the caller, and the other workers finish") {
  const Labs labs;
  const Scratch place;
  const BuildResult built = build_program(labs.layout, labs.lab, labs.submission(place, 0));
  REQUIRE(built.program);
  const std::size_t before = open_descriptors();
  for (const unsigned workers : {1u, 2u, 4u}) {
    JudgeOptions options;
    options.workers = workers;
    std::size_t calls = 0;
    options.progress = [&](std::size_t, std::size_t) {
      if (++calls == 3) throw std::runtime_error("no more of this");
    };
    CHECK_THROWS_WITH(judge_lab(labs.layout, labs.lab, built, options), "no more of this");
    options.progress = {};
    const LabVerdict after = judge_lab(labs.layout, labs.lab, built, options);
    CHECK(count(after, Status::not_written) == after.checks.size());
  }
  CHECK(open_descriptors() == before);
}

TEST_CASE("signals change no verdict") {
  const Labs labs;
  const Scratch place;
  JudgeOptions options;
  const SignalTimer interrupted;
  const BuildResult built = build_program(labs.layout, labs.lab, labs.submission(place, 0));
  INFO(built.failure);
  REQUIRE(built.program);
  const LabVerdict verdict = judge_lab(labs.layout, labs.lab, built, options);
  CHECK(count(verdict, Status::not_written) == verdict.checks.size());
  CHECK(interrupted.times() > 50);
}

TEST_CASE("without descriptors the grader ends with a line and status 3, whenever they run out") {
  const Labs labs;
  const Scratch place;
  labs.submission(place, 0);
  const std::string grader = (labs.layout.build / "bin" / "grader").string();
  std::size_t lacking = 0, judged = 0;
  for (int most = 17; most <= 40; ++most) {
    const auto run = sandbox::run_process(
        {"sh", "-c",
         fmt::format("ulimit -n {} && exec '{}' check variance '{}' --only 1.1", most, grader,
                     place.path().string())});
    CAPTURE(most, run.errors);
    CHECK(run.signal == 0);
    CHECK((run.exit_code == 1 || run.exit_code == 3));
    if (run.exit_code == 3) CHECK(last_line(run.errors).starts_with("lab: "));
    lacking += run.exit_code == 3;
    judged += run.exit_code == 1;
  }
  CHECK(lacking > 0);
  CHECK(judged > 0);
}

}  // namespace mc::tests::hygiene
