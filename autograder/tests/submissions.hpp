#pragma once
// Small submissions of lab 1, written for one test, and the programs that tests run. Includes what
// nearly every test of the grader needs.

#include <filesystem>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "checks/support/catch.hpp"
#include "judge/base/errors.hpp"
#include "judge/base/text_file.hpp"
#include "judge/checkout/labs.hpp"
#include "judge/checkout/layout.hpp"
#include "judge/judging/verdict.hpp"
#include "judge/submission/build.hpp"
#include "judge/submission/submission.hpp"
#include "sandbox/process.hpp"
#include "tests/text.hpp"

/// Names the result of a program that must end with status 0. A later failure shows its output.
#define REQUIRE_RUN(run, ...)      \
  auto run = __VA_ARGS__;          \
  CAPTURE(run.output, run.errors); \
  REQUIRE(run.succeeded())

namespace mc::tests {

namespace fs = std::filesystem;
using namespace grader;

using Words = std::vector<std::string>;

/// Bad usage: exit status 2, and an error that says why.
inline void check_refused(const sandbox::ProcessResult& run, const std::string& why = "") {
  CAPTURE(run.output, run.errors, why);
  CHECK(run.exit_code == 2);
  CHECK(contains(run.errors, why));
}

/// Runs ./lab as a user would; everything is built already.
inline sandbox::ProcessResult lab(const Words& words, sandbox::ProcessOptions options = {}) {
  options.environment.push_back({"MC_NO_BUILD", "1"});
  return sandbox::run_process(joined({(read_layout().bin / "lab").string()}, words), options);
}

/// A check's result, worth 5 points, without a run.
inline CheckResult result_of(const std::string& name, Status status,
                             const std::string& report = "") {
  CheckResult result;
  result.check = {name, name.substr(0, name.find(' ')), {}, 5};
  result.status = status;
  result.report = report;
  return result;
}

/// The verdict on a lab 1 that has these checks.
inline LabVerdict verdict_of(std::vector<CheckResult> results) {
  LabVerdict verdict;
  verdict.lab = {1, "variance", "1-variance", {}};
  verdict.checks = std::move(results);
  return verdict;
}

/// A temporary directory for one test.
class Scratch {
 public:
  explicit Scratch(const std::string& name = "scratch") {
    std::string pattern = (fs::temp_directory_path() / (name + "-XXXXXX")).string();
    path_ = mkdtemp(pattern.data());
  }
  ~Scratch() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  Scratch(const Scratch&) = delete;
  const fs::path& path() const { return path_; }
  fs::path write(const std::string& file, const std::string& text) const {
    fs::create_directories((path_ / file).parent_path());
    write_text(path_ / file, text);
    return path_ / file;
  }

 private:
  fs::path path_;
};

struct ZipFiles {
  fs::path directory, zip;
};

/// Zips the content of a directory, with paths relative to it.
inline void zip_content(const ZipFiles& files) {
  Words command{"cmake", "-E", "tar", "cf", files.zip.string(), "--format=zip"};
  std::set<std::string> names;  // in order
  for (const auto& entry : fs::directory_iterator(files.directory)) {
    names.insert(entry.path().filename().string());
  }
  command.insert(command.end(), names.begin(), names.end());
  // In the locale C, CMake finds no file whose name is not ASCII.
  REQUIRE_RUN(run, sandbox::run_process(command, {.directory = files.directory,
                                                  .environment = {{"LC_ALL", "C.UTF-8"}}}));
}

/// `git …` in a repository, which must succeed.
inline std::string git(const fs::path& repository, const Words& words) {
  REQUIRE_RUN(run, sandbox::run_process(joined({"git", "-C", repository.string(), "-c",
                                                "user.name=s", "-c", "user.email=s@example.org"},
                                               words),
                                        {.output = std::size_t{64} << 20}));
  return run.output;
}

/// A copy of a program of this build, as if it had been built for another checkout: it finds its
/// build directory by its own path, and the checkout by the layout file in there.
inline fs::path built_for(const fs::path& root, const fs::path& build, const char* program) {
  const Layout real = read_layout();
  fs::path copy = build / "bin" / program;
  fs::create_directories(build / "bin");
  fs::copy_file(real.build / "bin" / program, copy, fs::copy_options::skip_existing);
  write_text(build / "layout.json",
             with_change(read_text(real.build / "layout.json"), real.root.string(), root.string()));
  return copy;
}

/// The text of the starter, or of the solution, of lab 1.
inline std::string text_of(const fs::path& directory) {
  return read_text(directory / "variance.cpp");
}

/// Lab 1 of this checkout, and programs for it.
struct FirstLab {
  Layout layout = read_layout();
  std::vector<Lab> labs = find_labs(layout);
  const Lab& lab = find_lab(labs, "variance");
  std::string starter = text_of(layout.starter());

  /// Of the variance.cpp in a directory.
  BuildResult build(const fs::path& directory) const {
    return build_program(layout, lab, open_submission(labs, directory));
  }
  /// In a directory with the same name in every run: the same text is compiled only once.
  BuildResult build_text(const char* name, const std::string& text) const {
    const auto directory = layout.build / "tests" / name;
    fs::create_directories(directory);
    write_text(directory / "variance.cpp", text);
    return build(directory);
  }
};

/// The solution with a mistake in 1.7, so that there are passed and failed checks.
inline std::string text_with_mistake(const Layout& layout) {
  return with_change(text_of(layout.solutions()), "if (columns == 0) throw",
                     "if (columns == 77) throw");
}

/// The solution with this at the beginning of mean().
inline std::string text_with_first_line_of_mean(const Layout& layout, const std::string& line) {
  const std::string head = "double mean(std::span<const double> x) {\n";
  return with_change(text_of(layout.solutions()), head, head + line + '\n');
}

}  // namespace mc::tests
