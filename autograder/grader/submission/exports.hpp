#pragma once
// How learning platforms name what they export.

#include <filesystem>
#include <map>
#include <optional>
#include <string>

namespace mc::grader {

/// A file in a folder that all owners share, with its owner in its name.
struct PlatformName {
  std::string person;  ///< "doejane_123": who it is, to the platform
  std::string file;    ///< "variance.cpp": as it was handed in
  std::filesystem::path path;
  int attempt = 0;  ///< of several files of that name: the latest has the highest
};

/// Of Canvas, doejane_LATE_123_456_variance-1.cpp, and of Moodle,
/// "Jane Doe_123_assignsubmission_file_variance.cpp"; nothing for other names.
std::optional<PlatformName> named_by_platform(const std::filesystem::path& path);

/// Is this a directory or file of Moodle's that holds no files: an online text, comments?
bool is_moodle_text(const std::string& name);

/// The names and e-mail addresses of submission_metadata.yml, which Gradescope puts next to the
/// directories that it exports: "submission_11" -> "Jane Doe (jane@example.edu)". Groups are joined
/// by " & ". Empty if there is no such file.
std::map<std::string, std::string> gradescope_people(const std::filesystem::path& directory);

/// The id that the name of a directory or of a zip means, fit to be shown and to name a file.
std::string id_from_name(const std::string& name);

}  // namespace mc::grader
