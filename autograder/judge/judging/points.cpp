#include "judge/judging/points.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <stdexcept>

#include <fmt/format.h>

#include "judge/base/errors.hpp"
#include "judge/base/text_file.hpp"
#include "judge/reports/csv.hpp"
#include "runner/text.hpp"
#include "sandbox/printable.hpp"

namespace mc::grader {
namespace {

struct PointsLine {
  std::size_t number = 0;
  std::string what;
  double points = 0;
};

[[noreturn]] void refuse_line(std::size_t number, const std::string& why) {
  throw UsageError(fmt::format("{}, row {}: {}", points_file, number, why));
}

std::vector<PointsLine> lines_of_points(const std::filesystem::path& root) {
  std::vector<PointsLine> lines;
  std::size_t number = 0;
  for (const auto& row : csv_rows(read_text(root / points_file))) {
    ++number;
    if (row.empty() || row == std::vector<std::string>{"what", "points"}) continue;
    PointsLine one{number, row[0], NAN};
    try {
      if (row.size() == 2) text::parse(row[1], one.points);
    } catch (const std::invalid_argument&) {
      one.points = NAN;
    }
    const auto dot = one.what.find('.');
    const bool is_task = dot != std::string::npos && dot > 0 && dot + 1 < one.what.size() &&
                         one.what.find_first_not_of("0123456789") == dot &&
                         one.what[dot + 1] >= '0' && one.what[dot + 1] <= '9';
    if (!is_task || !std::isfinite(one.points) || one.points < 0) {
      refuse_line(number, "a line must be a task or a check, a comma, and its points");
    }
    lines.push_back(std::move(one));
  }
  return lines;
}

}  // namespace

void apply_points(const std::filesystem::path& root, const Lab& lab, std::vector<Check>& checks) {
  std::set<std::string> left_out;
  for (const PointsLine& line : lines_of_points(root)) {
    if (std::atoi(line.what.c_str()) != lab.number) continue;
    double before = 0;
    std::vector<Check*> named;
    for (Check& check : checks) {
      if (check.task != line.what && check.name != line.what) continue;
      named.push_back(&check);
      before += check.points;
    }
    if (named.empty()) {
      refuse_line(line.number, fmt::format("lab {} has no task or check '{}'", lab.number,
                                           sandbox::printable_line(line.what)));
    }
    for (Check* const check : named) {
      const double share =
          before > 0 ? check->points / before : 1 / static_cast<double>(named.size());
      check->points = line.points * share;
      if (line.points == 0) left_out.insert(check->name);
      if (line.points > 0) left_out.erase(check->name);
    }
  }
  std::erase_if(checks, [&](const Check& check) { return left_out.contains(check.name); });
}

void require_known_points(const Layout& layout, const std::vector<Lab>& labs) {
  if (!std::filesystem::exists(layout.submissions())) return;
  for (const PointsLine& line : lines_of_points(layout.root)) {
    const std::string task = line.what.substr(0, line.what.find(' '));
    const auto lab = std::ranges::find_if(
        labs, [&](const Lab& one) { return one.number == std::atoi(task.c_str()); });
    if (lab == labs.end()) {
      refuse_line(line.number, fmt::format("there is no lab {}", std::atoi(task.c_str())));
    }
    const std::string handout = read_text(layout.labs() / lab->folder / "README.md");
    if (handout.find("\n### " + task + ' ') == std::string::npos) {
      refuse_line(line.number,
                  fmt::format("lab {} has no task {}", lab->number, sandbox::printable_line(task)));
    }
  }
}

std::set<std::string> tasks_left_out(const std::filesystem::path& root) {
  std::set<std::string> tasks;
  for (const PointsLine& line : lines_of_points(root)) {
    if (line.points == 0 && line.what.find(' ') == std::string::npos) tasks.insert(line.what);
  }
  return tasks;
}

std::string without_section(const std::string& text, const std::string& heading) {
  auto begin = text.find('\n' + heading + ' ');
  if (begin == std::string::npos) begin = text.find('\n' + heading + '\n');
  if (begin == std::string::npos) return text;
  ++begin;
  auto end = text.size();
  // A heading of the same level or above ends it; "# " also begins comments in blocks.
  for (std::string mark = "\n## "; mark.size() <= heading.find(' ') + 2; mark.insert(1, "#")) {
    end = std::min(end, text.find(mark, begin));
  }
  return text.substr(0, begin) + (end < text.size() ? text.substr(end + 1) : "");
}

}  // namespace mc::grader
