#pragma once
// A class of small submissions of lab 1, and ./lab as a grader uses it.

#include "grader/gradebook/table.hpp"
#include "tests/submissions.hpp"

namespace mc::tests {

struct Course : Scratch {
  Layout layout = read_layout();
  std::vector<Lab> labs = find_labs(layout);
  std::vector<std::string> ids;

  void hand_in(const std::string& id, const std::string& text) {
    write("class/" + id + "/variance.cpp", text);
    ids.push_back(id);
  }
  /// Cheap submissions: most do not compile, a few are the starter.
  void hand_in_tiny(int count) {
    for (int i = 0; i < count; ++i) {
      const std::string id = fmt::format("s{:02}", i);
      hand_in(id, i % 5 == 0 ? fmt::format("// {}\n", i) + text_of(layout.starter())
                             : fmt::format("int {} is no name;\n", i));
    }
  }
  fs::path csv(const std::string& name = "grades") const { return path() / (name + ".csv"); }

  /// Runs a command that must succeed: its output.
  std::string output_of(const Words& words) const {
    REQUIRE_RUN(done, run(words));
    return done.output;
  }
  /// The table of a run that must succeed.
  Table graded(const Words& more) const {
    REQUIRE_RUN(done, grade(joined({"--csv", csv()}, more)));
    return read_table(csv());
  }

  sandbox::ProcessResult run(const Words& words,
                             const sandbox::ProcessOptions& options = {}) const {
    return sandbox::run_process(joined({layout.build / "bin" / "course"}, words), options);
  }
  sandbox::ProcessResult grade(const Words& more,
                               const sandbox::ProcessOptions& options = {}) const {
    return run(joined({"grade", path() / "class", "--lab", "variance"}, more), options);
  }
};

}  // namespace mc::tests
