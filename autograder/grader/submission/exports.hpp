#pragma once
// How learning platforms name what they export.

#include <filesystem>
#include <optional>
#include <string>

namespace mc::grader {

/// A file that stands beside those of all others, its owner in its name.
struct PlatformName {
  std::string person;  ///< "doejane_123": who it is, to the platform
  std::string file;    ///< "variance.cpp": as it was handed in
  std::filesystem::path path;
};

/// Of Canvas, doejane_LATE_123_456_variance-1.cpp, and of Moodle,
/// "Jane Doe_123_assignsubmission_file_variance.cpp"; nothing for other names.
std::optional<PlatformName> named_by_platform(const std::filesystem::path& path);

/// The id that the name of a directory or of a zip means, fit to be shown and to name a file.
std::string id_from_name(const std::string& name);

}  // namespace mc::grader
