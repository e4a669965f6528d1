#include "judge/checkout/hints.hpp"

#include <cstdlib>
#include <sstream>

#include "judge/base/text_file.hpp"

namespace mc::grader {
namespace {

constexpr std::string_view task_mark = "## ", step_mark = "### ";

std::string trimmed(const std::string& text) {
  const auto first = text.find_first_not_of('\n');
  if (first == std::string::npos) return {};
  return text.substr(first, text.find_last_not_of(" \n") - first + 1);
}

}  // namespace

std::vector<std::string> hints_for(const Layout& layout, const Lab& lab, const std::string& task) {
  std::istringstream lines(read_text(layout.labs() / lab.folder / "hints.md"));
  std::vector<std::string> steps;
  bool is_here = false;
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with(task_mark)) {
      is_here = line.substr(task_mark.size()) == task;
    } else if (is_here && line.starts_with(step_mark)) {
      steps.emplace_back();
    } else if (is_here && !steps.empty()) {
      steps.back() += line + '\n';
    }
  }
  for (std::string& step : steps) step = trimmed(step);
  return steps;
}

std::string with_fewer_hints(const std::string& text, int most) {
  std::istringstream lines(text);
  std::string all;
  bool is_kept = true;
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with(task_mark)) is_kept = true;
    if (line.starts_with(step_mark)) is_kept = std::atoi(line.c_str() + step_mark.size()) <= most;
    if (is_kept) all += line + '\n';
  }
  return all;
}

}  // namespace mc::grader
