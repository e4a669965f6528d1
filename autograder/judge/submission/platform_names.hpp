#pragma once
// The names that learning platforms give to files when all of a class are in one directory.

#include <optional>
#include <string>

namespace mc::grader {

/// One file of one person.
struct PlatformName {
  std::string person;  ///< everything that the platform put in front of the file, but LATE marks
  std::string key;     ///< the platform's number or time of this file; no two files share it
  std::string file;    ///< the student's name for it, without Canvas's count of attempts
  int attempt = 0;     ///< 2 for "variance-2.cpp" of Canvas
};

/// Canvas: doejane_LATE_4711_99_variance-2.cpp, anon_Ab12C_991_variance.cpp.
/// Moodle: Jane Doe_12_assignsubmission_file_variance.cpp.
/// Blackboard: Lab 1_jdoe_attempt_2026-01-02-03-04-05_variance.cpp.
/// Nothing for other names.
std::optional<PlatformName> named_by_platform(const std::string& name);

}  // namespace mc::grader
