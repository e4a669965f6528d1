#include "grader/submission/exports.hpp"

#include <algorithm>
#include <string_view>
#include <vector>

#include "runner/text.hpp"
#include "sandbox/printable.hpp"

namespace mc::grader {
namespace fs = std::filesystem;
namespace {

constexpr std::string_view moodles = "_assignsubmission_file";

bool is_count(std::string_view text) {
  return !text.empty() && text.find_first_not_of("0123456789") == std::string_view::npos;
}
/// A platform's number; "lab_1_2_alice.zip" is no such name.
bool is_key(std::string_view text) {
  return is_count(text) && text.size() > 2;
}

/// "variance-1.cpp" is what Canvas makes of a second "variance.cpp".
std::string without_count(const std::string& file) {
  const fs::path name = file;
  const std::string stem = name.stem().string();
  const auto dash = stem.rfind('-');
  if (dash == std::string::npos || !is_count(std::string_view(stem).substr(dash + 1))) return file;
  return stem.substr(0, dash) + name.extension().string();
}

}  // namespace

std::optional<PlatformName> named_by_platform(const fs::path& path) {
  const std::string name = path.filename().string();
  if (const auto at = name.find(moodles); at != std::string::npos && at > 0) {
    const std::size_t behind = at + moodles.size() + 1;
    if (behind >= name.size()) return {};
    return PlatformName{id_from_name(name.substr(0, at)), name.substr(behind), path};
  }
  const auto parts = text::split(name, '_');
  for (std::size_t i = 1; i + 2 < parts.size(); ++i) {
    if (!is_key(parts[i]) || !is_key(parts[i + 1])) continue;
    std::string person;
    for (std::size_t j = 0; j <= i; ++j) {
      if (parts[j] == "LATE") continue;
      person += (person.empty() ? "" : "_") + std::string(parts[j]);
    }
    const auto begin = static_cast<std::size_t>(parts[i + 2].data() - name.data());
    return PlatformName{id_from_name(person), without_count(name.substr(begin)), path};
  }
  return {};
}

std::string id_from_name(const std::string& name) {
  std::string id = sandbox::printable_line(name.substr(0, name.find(moodles)));
  std::replace(id.begin(), id.end(), '/', '_');
  constexpr std::size_t longest = 100;  // of a file's 255 bytes
  id = sandbox::shortened(id, longest);
  return id.empty() || id == "." || id == ".." ? "submission" : id;
}

}  // namespace mc::grader
