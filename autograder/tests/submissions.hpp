#pragma once
// Small submissions of lab 1, written for one test, and the programs that pack them.

#include <filesystem>
#include <string>
#include <vector>

#include "grader/base/text_file.hpp"
#include "grader/checkout/labs.hpp"
#include "grader/checkout/layout.hpp"
#include "grader/submission/build.hpp"
#include "grader/submission/submission.hpp"
#include "tests/require_run.hpp"
#include "tests/text.hpp"

namespace mc::tests {

/// A temporary directory for one test.
class Scratch {
 public:
  explicit Scratch(const std::string& name = "scratch") {
    std::string pattern = (std::filesystem::temp_directory_path() / (name + "-XXXXXX")).string();
    path_ = mkdtemp(pattern.data());
  }
  ~Scratch() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  Scratch(const Scratch&) = delete;
  const std::filesystem::path& path() const { return path_; }
  std::filesystem::path write(const std::string& file, const std::string& text) const {
    std::filesystem::create_directories((path_ / file).parent_path());
    grader::write_text(path_ / file, text);
    return path_ / file;
  }

 private:
  std::filesystem::path path_;
};

struct ZipFiles {
  std::filesystem::path directory, zip;
};

/// Zips the content of a directory, with paths relative to it.
inline void zip_content(const ZipFiles& files) {
  std::vector<std::string> command{"cmake", "-E", "tar", "cf", files.zip.string(), "--format=zip"};
  for (const auto& entry : std::filesystem::directory_iterator(files.directory)) {
    command.push_back(entry.path().filename().string());
  }
  REQUIRE_RUN(run, sandbox::run_process(command, {.directory = files.directory}));
}

/// `git …` in a repository, which must succeed.
inline std::string git(const std::filesystem::path& repository,
                       const std::vector<std::string>& words) {
  REQUIRE_RUN(run, sandbox::run_process(joined({"git", "-C", repository.string(), "-c",
                                                "user.name=s", "-c", "user.email=s@example.org"},
                                               words),
                                        {.output = std::size_t{64} << 20}));
  return run.output;
}

/// A copy of a program of this build, as if it had been built for another checkout: it finds its
/// build directory by its own path, and the checkout by the layout file in there.
inline std::filesystem::path built_for(const std::filesystem::path& root,
                                       const std::filesystem::path& build, const char* program) {
  const grader::Layout real = grader::read_layout();
  auto copy = build / "bin" / program;
  std::filesystem::create_directories(build / "bin");
  std::filesystem::copy_file(real.build / "bin" / program, copy,
                             std::filesystem::copy_options::skip_existing);
  grader::write_text(build / "layout.txt",
                     with_change(grader::read_text(real.build / "layout.txt"),
                                 "root=" + real.root.string(), "root=" + root.string()));
  return copy;
}

/// The text of the starter, or of the solution, of lab 1.
inline std::string text_of(const std::filesystem::path& directory) {
  return grader::read_text(directory / "variance.cpp");
}

/// Lab 1 of this checkout, and programs for it.
struct FirstLab {
  grader::Layout layout = grader::read_layout();
  std::vector<grader::Lab> labs = grader::find_labs(layout);
  const grader::Lab& lab = grader::find_lab(labs, "variance");
  std::string starter = text_of(layout.starter());

  /// Of the variance.cpp in a directory.
  grader::BuildResult build(const std::filesystem::path& directory) const {
    return grader::build_program(layout, lab, grader::open_submission(labs, directory));
  }
  /// In a directory with the same name in every run: the same text is compiled only once.
  grader::BuildResult build_text(const char* name, const std::string& text) const {
    const auto directory = layout.build / "tests" / name;
    std::filesystem::create_directories(directory);
    grader::write_text(directory / "variance.cpp", text);
    return build(directory);
  }
};

/// The solution with a mistake in 1.7, so that there are passed and failed checks.
inline std::string text_with_mistake(const grader::Layout& layout) {
  return with_change(text_of(layout.solutions()), "if (columns == 0) throw",
                     "if (columns == 77) throw");
}

/// The solution with this at the beginning of mean().
inline std::string text_with_first_line_of_mean(const grader::Layout& layout,
                                                const std::string& line) {
  const std::string head = "double mean(std::span<const double> x) {\n";
  return with_change(text_of(layout.solutions()), head, head + line + '\n');
}

}  // namespace mc::tests
