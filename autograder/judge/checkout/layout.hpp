#pragma once
// Paths and compiler settings: found by CMake when it configures, or, in a handout with a compiled
// judge, at each start.

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace mc::grader {

struct Layout {
  std::filesystem::path root;      ///< the checkout
  std::filesystem::path build;     ///< CMake's build directory, or a handout's
  std::filesystem::path bin;       ///< the judge's programs
  bool judge_is_compiled = false;  ///< is this a handout without the judge's sources?
  std::string compiler;            ///< full path of the C++ compiler; empty if a handout finds none
  bool is_clang = false;
  bool sanitized =
      false;  ///< are grader and checks built with a sanitizer? Then memory limits do not apply
  std::string version;                  ///< of the project, and the commit if git knows it
  std::vector<std::string> link_flags;  ///< -static if programs are linked statically
  std::map<std::string, std::vector<std::filesystem::path>>
      objects;                                            ///< lab name -> experiments, runner
  std::map<std::string, std::vector<std::string>> peers;  ///< installed library -> flags to link it

  std::filesystem::path labs() const { return root / "labs"; }
  std::filesystem::path solutions() const { return root / "solutions"; }
  std::filesystem::path submissions() const { return root / "autograder" / "submissions"; }
  std::filesystem::path starter() const { return root / "starter"; }
  std::filesystem::path checks(const std::string& lab) const { return bin / ("checks_" + lab); }
  /// The program that measures for the lab's plots and for bench.
  std::filesystem::path measurements(const std::string& lab) const {
    return bin / ("measure_" + lab);
  }
};

/// Reads layout.json, in the directory above this program's: CMake writes it into its build
/// directory, ./lab handout into autograder/bin. Throws MachineError if it is missing.
Layout read_layout();

}  // namespace mc::grader
