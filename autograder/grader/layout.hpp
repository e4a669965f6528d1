#pragma once
// Where everything is, and how programs are compiled: what CMake found when it configured.

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace mc::grader {

struct Layout {
  std::filesystem::path root;   ///< the checkout
  std::filesystem::path build;  ///< CMake's build directory
  std::string compiler;         ///< full path of the C++ compiler
  bool is_clang = false;
  std::string version;                  ///< of the checkout: git describe, or "unknown"
  std::vector<std::string> link_flags;  ///< -static where programs are
  std::map<std::string, std::vector<std::filesystem::path>>
      objects;                                            ///< lab name -> experiments, runner
  std::map<std::string, std::vector<std::string>> peers;  ///< installed library -> flags to link it

  std::filesystem::path labs() const { return root / "labs"; }
  std::filesystem::path solutions() const { return root / "solutions"; }
  std::filesystem::path submissions() const { return root / "autograder" / "submissions"; }
  std::filesystem::path starter() const { return root / "starter"; }
  std::filesystem::path checks(const std::string& lab) const {
    return build / "bin" / ("checks_" + lab);
  }
};

/// Reads build/layout.txt, which CMake writes. Throws MachineError where it is missing.
Layout read_layout();

}  // namespace mc::grader
