#pragma once
// The students' handout.

#include "commands/course_copy.hpp"
#include "tests/classes/course.hpp"

namespace mc::tests {

/// A freshly written handout.
struct Handout : Course {
  fs::path root = path() / "labs";
  sandbox::ProcessResult written;
  fs::path search_path;  ///< in place of PATH, if set

  explicit Handout(const Words& more = {}) {
    Words words = joined({"handout", root.string()}, more);
    if (!has_compiled_judge(layout)) words.emplace_back("--with-sources");
    written = tests::lab(words);
  }
  sandbox::ProcessResult lab(const Words& words) const {
    return run_here(joined({(root / "lab").string()}, words));
  }
  /// A line of a shell, in the handout.
  sandbox::ProcessResult lab_words(const std::string& line) const {
    return run_here({"sh", "-c", line});
  }

 private:
  sandbox::ProcessResult run_here(const Words& words) const {
    sandbox::ProcessOptions options{.directory = root,
                                    .environment = {{"MC_BUILD", ""}, {"CI", "true"}}};
    if (!search_path.empty()) options.environment.push_back({"PATH", search_path.string()});
    return sandbox::run_process(words, options);
  }
};

}  // namespace mc::tests
