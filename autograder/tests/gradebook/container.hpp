#pragma once
// The environment in which Gradescope grades.

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "tests/gradebook/course.hpp"

namespace mc::tests {

/// Gradescope's /autograder, in a temporary directory.
struct Container : Course {
  using Path = std::filesystem::path;
  Path root = std::filesystem::canonical(path()) / "autograder", zip = path() / "autograder.zip";
  Path source = root / "source", handed = root / "submission",
       results = root / "results" / "results.json";
  sandbox::ProcessResult written;

  explicit Container(const std::vector<std::string>& more) {
    written = run(joined({"gradescope", "variance", "--out", zip.string()}, more));
    for (const Path& place : {source, handed, results.parent_path()}) {
      std::filesystem::create_directories(place);
    }
    sandbox::run_process({"cmake", "-E", "tar", "xf", zip.string()}, {.directory = source});
    grader::write_text(root / "submission_metadata.json", "{}");
  }
  sandbox::ProcessResult script(const std::string& name) const {
    return sandbox::run_process(
        {(source / name).string()},
        {.directory = root, .environment = {{"AUTOGRADER_ROOT", root.string()}, {"MC_BUILD", ""}}});
  }
  /// Hands in only these files, and grades them.
  sandbox::ProcessResult grade(const std::vector<std::pair<Path, std::string>>& files) const {
    std::filesystem::remove_all(handed);
    std::filesystem::create_directories(handed);
    for (const auto& [file, text] : files) {
      std::filesystem::create_directories((handed / file).parent_path());
      grader::write_text(handed / file, text);
    }
    return script("run_autograder");
  }
};

}  // namespace mc::tests
