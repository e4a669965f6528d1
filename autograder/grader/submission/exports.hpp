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
};

/// Parses Canvas's doejane_LATE_123_456_variance-1.cpp and Moodle's
/// "Jane Doe_123_assignsubmission_file_variance.cpp"; nothing for other names.
std::optional<PlatformName> named_by_platform(const std::filesystem::path& path);

/// Is this a Moodle directory or file without submitted files: an online text, comments?
bool is_moodle_text(const std::string& name);

/// The names and e-mail addresses of submission_metadata.yml, which Gradescope puts next to the
/// directories that it exports: "submission_11" -> "Jane Doe (jane@example.edu)". Groups are joined
/// by " & ". Empty if there is no such file.
std::map<std::string, std::string> gradescope_people(const std::filesystem::path& directory);

/// The id that a directory or zip name stands for, safe to show and to use as a file name.
std::string id_from_name(const std::string& name);

}  // namespace mc::grader
