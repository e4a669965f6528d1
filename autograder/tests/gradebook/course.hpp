#pragma once
// A class of small submissions of lab 1, and ./lab as a grader uses it.

#include <filesystem>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "grader/base/text_file.hpp"
#include "grader/checkout/labs.hpp"
#include "grader/checkout/layout.hpp"
#include "sandbox/process.hpp"
#include "tests/submissions.hpp"

namespace mc::tests {

struct Course : Scratch {
  grader::Layout layout = grader::read_layout();
  std::vector<grader::Lab> labs = grader::find_labs(layout);
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
  std::filesystem::path csv(const std::string& name = "grades") const {
    return path() / (name + ".csv");
  }

  sandbox::ProcessResult run(const std::vector<std::string>& words,
                             const sandbox::ProcessOptions& options = {}) const {
    return sandbox::run_process(joined({(layout.build / "bin" / "course").string()}, words),
                                options);
  }
  sandbox::ProcessResult grade(const std::vector<std::string>& more,
                               const sandbox::ProcessOptions& options = {}) const {
    return run(joined({"grade", (path() / "class").string(), "--lab", "variance"}, more), options);
  }
};

}  // namespace mc::tests
