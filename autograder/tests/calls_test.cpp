// Calls that are sent ahead (checks/support/calls.hpp) change no verdict, whatever the file says.
#include <filesystem>
#include <string>
#include <vector>

#include "checks/support/catch.hpp"
#include "grader/judging/judge.hpp"
#include "grader/submission/submission.hpp"
#include "tests/submissions.hpp"

namespace mc::tests {

using namespace grader;
namespace fs = std::filesystem;

namespace {

struct Judge {
  Layout layout = read_layout();
  std::vector<Lab> labs = find_labs(layout);
  const Lab& lab = find_lab(labs, "variance");
  Scratch place, calls;

  /// How each check ended, with its whole report.
  std::string reports(const std::string& text, const fs::path& sent_ahead) const {
    place.write("variance.cpp", text);
    const BuildResult built = build_program(layout, lab, open_submission(labs, place.path()));
    INFO(built.failure);
    REQUIRE(built.program);
    JudgeOptions options;
    options.seed = 5;
    options.calls = sent_ahead;
    std::string all;
    for (const CheckResult& result : judge_lab(layout, lab, built, options).checks) {
      all += result.check.name + ": " + std::to_string(static_cast<int>(result.status)) + '\n' +
             result.report + result.printed;
    }
    return all;
  }
};

}  // namespace

TEST_CASE("calls that are sent ahead change no verdict", "[.calls]") {
  const Judge judge;
  const std::string right = text_of(judge.layout.solutions());
  const std::string alone = judge.reports(right, {});
  CHECK(judge.reports(right, judge.calls.path()) == alone);  // keeps them
  CHECK_FALSE(fs::is_empty(judge.calls.path()));
  CHECK(judge.reports(right, judge.calls.path()) == alone);

  const auto with_line = [&](const char* line) {
    return text_with_first_line_of_mean(judge.layout, line);
  };
  for (const std::string& wrong :
       {text_with_mistake(judge.layout), with_line("if (x.size() == 3) abort();"),
        with_line("if (x.size() == 3) printf(\"3\\n\");"),
        with_line("static int calls = 0; if (++calls == 1) return 0;")}) {
    CHECK(judge.reports(wrong, judge.calls.path()) == judge.reports(wrong, {}));
  }
  for (const fs::directory_entry& file : fs::directory_iterator(judge.calls.path()))
    fs::resize_file(file, 100);
  CHECK(judge.reports(right, judge.calls.path()) == alone);
  for (const fs::directory_entry& file : fs::directory_iterator(judge.calls.path()))
    fs::resize_file(file, 0);
  CHECK(judge.reports(right, judge.calls.path()) == alone);
  CHECK(judge.reports(right, judge.place.path() / "none") == alone);
}

}  // namespace mc::tests
