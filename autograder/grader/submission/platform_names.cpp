#include "grader/submission/platform_names.hpp"

#include <cstdlib>
#include <regex>

namespace mc::grader {
namespace {

/// Canvas renames a second "variance.cpp" to "variance-1.cpp".
void remove_count(PlatformName& one) {
  static const std::regex counted(R"((.+)-(\d{1,4})(\.[^.]+))");
  std::smatch part;
  if (!std::regex_match(one.file, part, counted)) return;
  one.attempt = std::atoi(part[2].str().c_str());
  one.file = part[1].str() + part[3].str();
}

}  // namespace

std::optional<PlatformName> named_by_platform(const std::string& name) {
  // The platform's part is in front, and Canvas keeps such numbers out of a person's name, so the
  // first match is the platform's, whatever the student called the file.
  static const std::regex canvas(R"((.+?_(?:LATE_)?\d{2,})_(?:LATE_)?(\d{2,})_(.+))"),
      anonymous(R"((anon_(?:LATE_)?[A-Za-z0-9]{5})_(?:LATE_)?(\d{2,})_(.+))"),
      moodle(R"((.+?_\d+)_assignsubmission_file_(.+))"),
      blackboard(R"((.+?)_attempt_(\d{4}(?:-\d\d){5})(?:_(.+)|\.txt))");
  std::smatch part;
  // A name of unbounded length would take std::regex unbounded memory.
  if (name.size() > 255) return {};
  if (std::regex_match(name, part, moodle)) {
    return PlatformName{part[1], name, part[2], 0};
  }
  if (std::regex_match(name, part, blackboard)) {
    return PlatformName{part[1], name, part[3], 0};
  }
  if (std::regex_match(name, part, anonymous) || std::regex_match(name, part, canvas)) {
    static const std::regex late("_LATE_");
    PlatformName found{std::regex_replace(part[1].str(), late, "_"), part[2], part[3], 0};
    remove_count(found);
    return found;
  }
  return {};
}

}  // namespace mc::grader
