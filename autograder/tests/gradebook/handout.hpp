#pragma once
// The students' handout.

#include <filesystem>
#include <string>
#include <vector>

#include "tests/gradebook/course.hpp"

namespace mc::tests {

/// A freshly cloned handout.
struct Handout : Course {
  std::filesystem::path root = path() / "labs";
  sandbox::ProcessResult written;

  explicit Handout(const std::vector<std::string>& more = {},
                   const std::filesystem::path& where = {}) {
    if (!where.empty()) root = where;
    std::vector<std::string> words{"handout", root.string()};
    words.insert(words.end(), more.begin(), more.end());
    written = run(words);
  }
  sandbox::ProcessResult git(std::vector<std::string> words) const {
    words.insert(words.begin(), {"git", "-C", root.string()});
    return sandbox::run_process(words, {.output = std::size_t{64} << 20});
  }
  sandbox::ProcessResult lab(std::vector<std::string> words) const {
    words.insert(words.begin(), (root / "lab").string());
    return sandbox::run_process(
        words, {.directory = root, .environment = {{"MC_BUILD", ""}, {"CI", "true"}}});
  }
};

}  // namespace mc::tests
