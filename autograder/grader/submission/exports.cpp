#include "grader/submission/exports.hpp"

#include <algorithm>
#include <cstdlib>
#include <string_view>
#include <vector>

#include "grader/base/text_file.hpp"
#include "runner/text.hpp"
#include "sandbox/printable.hpp"

namespace mc::grader {
namespace fs = std::filesystem;
namespace {

constexpr std::string_view moodles = "_assignsubmission_";

bool is_count(std::string_view text) {
  return !text.empty() && text.find_first_not_of("0123456789") == std::string_view::npos;
}
/// A platform's number; "lab_1_2_alice.zip" does not have one.
bool is_key(std::string_view text) {
  return is_count(text) && text.size() > 2;
}

/// Canvas renames a second "variance.cpp" to "variance-1.cpp".
void remove_count(PlatformName& one) {
  const fs::path name = one.file;
  const std::string stem = name.stem().string();
  const auto dash = stem.rfind('-');
  if (dash == std::string::npos || !is_count(std::string_view(stem).substr(dash + 1))) return;
  one.file = stem.substr(0, dash) + name.extension().string();
  one.attempt = std::atoi(stem.c_str() + dash + 1);
}

/// The value after ":name: " or ":email: "; YAML may quote it.
std::string yaml_value(std::string_view line) {
  const auto value = line.substr(line.find(": ") + 2);
  constexpr const char* around = " \r'\"";
  const auto first = value.find_first_not_of(around), last = value.find_last_not_of(around);
  return first == std::string_view::npos ? "" : std::string(value.substr(first, last + 1 - first));
}

}  // namespace

std::optional<PlatformName> named_by_platform(const fs::path& path) {
  const std::string name = path.filename().string();
  if (const auto at = name.find(moodles); at != std::string::npos && at > 0) {
    // Jane Doe_12_assignsubmission_file_variance.cpp; an online text holds no file.
    constexpr std::string_view files = "file_";
    const std::size_t kind = at + moodles.size();
    if (is_moodle_text(name)) return PlatformName{id_from_name(name.substr(0, at)), "", path};
    if (!std::string_view(name).substr(kind).starts_with(files)) return {};
    if (kind + files.size() >= name.size()) return {};
    return PlatformName{id_from_name(name.substr(0, at)), name.substr(kind + files.size()), path};
  }
  const auto parts = text::split(name, '_');
  for (std::size_t i = 1; i + 2 < parts.size(); ++i) {
    if (!is_key(parts[i]) || !is_key(parts[i + 1])) continue;
    PlatformName found;
    for (std::size_t j = 0; j <= i; ++j) {
      if (parts[j] == "LATE") {  // the mark of Canvas, not a part of the name
        found.late = true;
      } else {
        found.person += (found.person.empty() ? "" : "_") + std::string(parts[j]);
      }
    }
    found.person = id_from_name(found.person);
    found.file = name.substr(static_cast<std::size_t>(parts[i + 2].data() - name.data()));
    found.path = path;
    remove_count(found);
    return found;
  }
  return {};
}

bool is_moodle_text(const std::string& name) {
  const auto at = name.find(moodles);
  return at != std::string::npos &&
         !std::string_view(name).substr(at + moodles.size()).starts_with("file");
}

std::map<std::string, GradescopeEntry> gradescope_entries(const fs::path& directory) {
  // With all results of a class it is longer than any source.
  constexpr std::uintmax_t longest = std::uintmax_t{64} << 20;
  const fs::path file = directory / "submission_metadata.yml";
  std::map<std::string, GradescopeEntry> entries;
  if (!fs::is_regular_file(fs::symlink_status(file)) || fs::file_size(file) > longest) return {};
  const std::string text = read_text(file);  // outlives its lines
  std::string submission, name;
  for (const std::string_view line : text::split(text, '\n')) {
    const auto begin = line.find_first_not_of(" -");
    if (begin == std::string_view::npos) continue;
    const std::string_view words = line.substr(begin);
    if (words.starts_with("submission_") && words.ends_with(':')) {
      submission = words.substr(0, words.size() - 1);
    } else if (words.starts_with(":name: ")) {
      name = yaml_value(words);
      std::string& all = entries[submission].people;
      all += (all.empty() ? "" : " & ") + name;
    } else if (words.starts_with(":email: ") && !entries[submission].people.empty()) {
      entries[submission].people += " (" + yaml_value(words) + ")";
    } else if (words.starts_with(":created_at: ") && entries[submission].submitted.empty()) {
      // Later ones are those of earlier attempts.
      entries[submission].submitted = yaml_value(words).substr(0, sizeof "2026-01-02 03:04:05" - 1);
    }
  }
  return entries;
}

std::string id_from_name(const std::string& name) {
  std::string id = sandbox::printable_line(name.substr(0, name.find(moodles)));
  std::ranges::replace(id, '/', '_');
  constexpr std::size_t longest = 100;  // of a file's 255 bytes
  id = sandbox::shortened(id, longest);
  return id.empty() || id == "." || id == ".." ? "submission" : id;
}

}  // namespace mc::grader
