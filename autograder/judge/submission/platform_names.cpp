#include "judge/submission/platform_names.hpp"

#include <algorithm>
#include <cstdlib>
#include <string_view>
#include <vector>

#include "runner/text.hpp"

namespace mc::grader {
namespace {

/// So many digits and nothing else.
bool is_number(std::string_view text, std::size_t least = 1) {
  return text.size() >= least && text.find_first_not_of("0123456789") == std::string_view::npos;
}

/// Canvas renames a second "variance.cpp" to "variance-1.cpp".
void remove_count(PlatformName& one) {
  const auto dot = std::min(one.file.rfind('.'), one.file.size()), dash = one.file.rfind('-', dot);
  if (dash == std::string::npos || dash == 0) return;
  const std::string count = one.file.substr(dash + 1, dot - dash - 1);
  if (!is_number(count) || count.size() > 4) return;
  one.attempt = std::atoi(count.c_str());
  one.file.erase(dash, dot - dash);
}

/// PERSON_LATE_4711_99_FILE; anonymous grading has five letters and digits in place of the first
/// number. Canvas keeps such numbers out of a person's name, so the first match is its own,
/// whatever the student called the file.
std::optional<PlatformName> named_by_canvas(const std::string& name) {
  std::vector<std::string_view> parts = text::split(name, '_');
  PlatformName found;
  for (std::size_t i = 0; i + 1 < parts.size(); ++i) {
    if (parts[i] == "LATE" && i > 0) continue;  // a mark, not a part of the name
    const bool is_anonymous = i == 1 && parts[0] == "anon" && parts[i].size() == 5;
    const std::size_t next = i + 1 < parts.size() && parts[i + 1] == "LATE" ? i + 2 : i + 1;
    found.person += (i > 0 ? "_" : "") + std::string(parts[i]);
    if (i == 0 || !(is_anonymous || is_number(parts[i], 2))) continue;
    if (next + 1 >= parts.size() || !is_number(parts[next], 2)) continue;
    found.key = parts[next];
    found.file = name.substr(static_cast<std::size_t>(parts[next + 1].data() - name.data()));
    remove_count(found);
    return found;
  }
  return {};
}

/// "2026-01-02-03-04-05"
bool is_time(std::string_view text) {
  const auto parts = text::split(text, '-');
  return parts.size() == 6 && parts[0].size() == 4 &&
         std::all_of(parts.begin(), parts.end(), [](auto part) { return is_number(part, 2); });
}

}  // namespace

std::optional<PlatformName> named_by_platform(const std::string& name) {
  constexpr std::string_view moodle = "_assignsubmission_file_", blackboard = "_attempt_";
  if (const auto at = name.find(moodle); at != std::string::npos && at > 0) {
    const std::string file = name.substr(at + moodle.size());
    return file.empty() ? std::nullopt
                        : std::optional(PlatformName{name.substr(0, at), name, file, 0});
  }
  constexpr std::size_t time_size = sizeof "2026-01-02-03-04-05" - 1;
  if (const auto at = name.find(blackboard); at != std::string::npos && at > 0) {
    const std::size_t time = at + blackboard.size(), end = time + time_size;
    if (name.size() > end && is_time(std::string_view(name).substr(time, time_size)) &&
        (name[end] == '_' || name.substr(end) == ".txt")) {  // the latter is the platform's own
      return PlatformName{name.substr(0, at), name, name[end] == '_' ? name.substr(end + 1) : "",
                          0};
    }
  }
  return named_by_canvas(name);
}

}  // namespace mc::grader
