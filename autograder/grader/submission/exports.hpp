#pragma once
// The file names in exports of learning platforms.

#include <filesystem>
#include <map>
#include <optional>
#include <string>

namespace mc::grader {

/// A file in a folder that all owners share, with its owner in its name.
struct PlatformName {
  std::string person;  ///< "doejane_123": the platform's name for the person
  std::string file;    ///< "variance.cpp": the submitted name
  std::filesystem::path path;
  int attempt = 0;  ///< of several files with that name, the latest has the highest
  bool late = false;
};

/// Parses Canvas's doejane_LATE_123_456_variance-1.cpp and Moodle's
/// "Jane Doe_123_assignsubmission_file_variance.cpp"; nothing for other names.
std::optional<PlatformName> named_by_platform(const std::filesystem::path& path);

/// Is this a Moodle directory or file without submitted files: an online text, comments?
bool is_moodle_text(const std::string& name);

/// What submission_metadata.yml says of a directory next to it.
struct GradescopeEntry {
  std::string people;     ///< "Jane Doe (jane@example.edu)"; groups are joined by " & "
  std::string submitted;  ///< "2026-01-02 03:04:05 Z"
};

/// By directory, "submission_11". Empty if there is no such file.
std::map<std::string, GradescopeEntry> gradescope_entries(const std::filesystem::path& directory);

/// The id that a directory or zip name stands for, safe to show and to use as a file name.
std::string id_from_name(const std::string& name);

}  // namespace mc::grader
