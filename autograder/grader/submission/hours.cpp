#include "grader/submission/hours.hpp"

#include <string>
#include <string_view>
#include <system_error>

#include <fmt/format.h>

#include "grader/submission/source.hpp"
#include "runner/text.hpp"
#include "sandbox/printable.hpp"

namespace mc::grader {
namespace fs = std::filesystem;
namespace {

/// The text after the colon of the last line that begins with "Hours".
std::string hours_in(const std::string& answers) {
  constexpr std::size_t longest = 20;
  constexpr const char* blanks = " \t\r*_";
  std::string hours;
  for (const std::string_view line : text::split(answers, '\n')) {
    const auto colon = line.rfind(':');
    if (!line.starts_with("Hours") || colon == std::string_view::npos) continue;
    const auto value = line.substr(colon + 1);
    const auto first = value.find_first_not_of(blanks), last = value.find_last_not_of(blanks);
    hours = first == std::string_view::npos ? "" : value.substr(first, last + 1 - first);
  }
  return sandbox::shortened(sandbox::printable_line(hours), longest);
}

}  // namespace

void read_hours(const std::vector<Lab>& labs, Submission& submission) {
  for (const Lab& lab : labs) {
    const auto found = submission.files.find(lab.name);
    if (found == submission.files.end()) continue;
    fs::path place = found->second.parent_path();
    if (place.filename() == "starter") place = place.parent_path();
    const fs::path answers = place / "answers" / (lab.folder + ".md");
    std::error_code ignored;  // links may lead anywhere
    if (!fs::is_directory(fs::symlink_status(place / "answers", ignored)) ||
        !fs::is_regular_file(fs::symlink_status(answers, ignored))) {
      continue;
    }
    const std::string hours = hours_in(read_source(answers).text);
    if (!hours.empty()) submission.delivery.hours[lab.name] = hours;
  }
}

}  // namespace mc::grader
