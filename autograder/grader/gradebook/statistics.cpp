#include "grader/gradebook/statistics.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>
#include <utility>

#include "runner/text.hpp"

namespace mc::grader {
namespace {

std::optional<double> points_in(const Table& table, const Row& row, const std::string& column) {
  const std::string text = field(row, column);
  if (text.empty()) return {};
  if (const auto value = finite_number(text)) return value;
  throw UsageError(fmt::format("{}: '{}' of {} is not a number of points, in column '{}'",
                               sandbox::printable_line(table.file.string()), text, field(row, "id"),
                               column));
}

/// 0 to 200 from what a student wrote, "7.5" or "7.5 h"; nothing for anything else.
std::optional<double> hours_in(const std::string& answer) {
  constexpr double most = 200;
  const auto end = std::min(answer.find_first_not_of("0123456789."), answer.size());
  const std::string unit =
      answer.substr(std::min(answer.find_first_not_of(' ', end), answer.size()));
  if (!unit.empty() && unit != "h" && unit != "hours") return {};
  const auto hours = finite_number(answer.substr(0, end));
  return hours && *hours >= 0 && *hours <= most ? hours : std::nullopt;
}

/// Should this row's lab have been judged, but could not be?
bool lacks_grade(const Row& row, const Lab& lab) {
  const std::string status = field(row, lab.name + " status");
  return status == "not judged" || status == "unreadable";
}

/// This check's result, if the verdict has it.
const CheckResult* result_in(const Verdict* verdict, const std::string& check) {
  if (verdict == nullptr) return nullptr;
  for (const LabVerdict& lab : verdict->labs) {
    for (const CheckResult& result : lab.checks) {
      if (result.check.name == check) return &result;
    }
  }
  return nullptr;
}

/// Attempts: the points of each check, in the order of the columns.
using Points = std::vector<std::vector<std::optional<double>>>;

std::optional<double> discrimination_of(const Points& points, std::size_t check) {
  std::vector<bool> passed;
  std::vector<double> rest;
  for (const auto& one : points) {
    if (!one[check]) continue;  // this row's table lacks the check
    double all = 0;
    for (const auto& earned : one) all += earned.value_or(0);
    passed.push_back(*one[check] > 0);
    rest.push_back(all - *one[check]);
  }
  return point_biserial(passed, rest);
}

/// What became of one check of an attempt.
std::size_t& outcome_in(CheckStatistics& check, double earned, const CheckResult* result) {
  if (earned > 0) return check.passed;
  switch (result == nullptr ? Status::failed : result->status) {
    case Status::passed:  // a check may have 0 points
      return check.passed;
    case Status::not_written:
      return check.not_written;
    case Status::waiting:
      return check.waiting;
    case Status::withheld:
      return check.withheld;
    default:
      return check.wrong;
  }
}

/// The tasks of these checks, with the points of all their checks: those that verdicts state, else
/// the most that someone earned.
std::vector<TaskStatistics> tasks_of(const std::vector<std::string>& checks, const Points& points,
                                     const std::map<std::string, Verdict>& verdicts) {
  std::vector<TaskStatistics> tasks;
  for (std::size_t i = 0; i < checks.size(); ++i) {
    const std::string task = checks[i].substr(0, checks[i].find(' '));
    if (tasks.empty() || tasks.back().task != task) tasks.push_back({task, {}, 0, 0, 0});
    tasks.back().checks.push_back(checks[i]);
    double most = 0;
    for (const auto& one : points) most = std::max(most, one[i].value_or(0));
    for (const auto& [id, verdict] : verdicts) {
      const CheckResult* const result = result_in(&verdict, checks[i]);
      if (result != nullptr && result->check.points > 0) most = result->check.points;
      if (result != nullptr) break;
    }
    tasks.back().points += most;
  }
  std::size_t first = 0;
  for (TaskStatistics& task : tasks) {
    double earned = 0;
    for (const auto& one : points) {
      double sum = 0;
      for (std::size_t i = 0; i < task.checks.size(); ++i) sum += one[first + i].value_or(0);
      earned += sum;
      task.complete += task.points > 0 && sum >= task.points;
    }
    const double all = task.points * static_cast<double>(points.size());
    task.share = all > 0 ? earned / all : 0;
    first += task.checks.size();
  }
  return tasks;
}

LabStatistics lab_statistics(const Table& table, const std::map<std::string, Verdict>& verdicts,
                             const Lab& lab, const std::vector<std::string>& checks) {
  LabStatistics statistics;
  statistics.lab = lab;
  for (const std::string& check : checks) statistics.checks.push_back({check, 0, 0, 0, 0, 0, {}});
  Points points;
  for (const Row& row : table.rows) {
    const auto total = points_in(table, row, lab.name + " total");
    const std::string status = field(row, lab.name + " status");
    const auto found = verdicts.find(field(row, "id"));
    const Verdict* const verdict = found == verdicts.end() ? nullptr : &found->second;
    const bool has_begun = std::ranges::any_of(checks, [&](const std::string& check) {
      const CheckResult* const result = result_in(verdict, check);
      return result == nullptr || result->status != Status::not_written;
    });
    if (const std::string answer = field(row, lab.name + " hours"); !answer.empty()) {
      const auto hours = hours_in(answer);
      if (hours) statistics.hours.push_back(*hours);
      statistics.unusable_hours += !hours;
    }
    const bool has_program = status != "no file" && status != "no program";
    if (!total && lacks_grade(row, lab)) {
      ++statistics.not_judged;
    } else if (total.value_or(0) > 0 || (total && has_program && (has_begun || checks.empty()))) {
      statistics.totals.push_back(*total);
    } else if (status == "no program") {
      ++statistics.not_compiled;
    } else if (total || status == "no file") {
      ++statistics.not_attempted;
    }
    if (!total || !has_program || !(has_begun || *total > 0)) continue;
    std::vector<std::optional<double>> of_row;
    for (CheckStatistics& check : statistics.checks) {
      of_row.push_back(points_in(table, row, check.name));
      if (of_row.back()) ++outcome_in(check, *of_row.back(), result_in(verdict, check.name));
    }
    points.push_back(std::move(of_row));
  }
  for (std::size_t i = 0; i < checks.size(); ++i) {
    statistics.checks[i].discrimination = discrimination_of(points, i);
  }
  statistics.tasks = tasks_of(checks, points, verdicts);
  double all = 0;
  for (const TaskStatistics& task : statistics.tasks) all += task.points;
  if (!verdicts.empty() && all > 0) statistics.points = all;
  return statistics;
}

/// The hints in the reports of failed checks, each once.
std::set<std::string> hints_of(const Verdict& verdict) {
  constexpr std::string_view likely = "likely    ", rule = "rule      ";
  std::set<std::string> hints;
  for (const LabVerdict& lab : verdict.labs) {
    for (const CheckResult& result : lab.checks) {
      if (result.status != Status::failed) continue;
      for (const std::string_view line : text::split(result.report, '\n')) {
        if (line.starts_with(likely) || line.starts_with(rule)) {
          hints.insert(sandbox::printable_line(line.substr(likely.size())));
        }
      }
    }
  }
  return hints;
}

/// The value with this share of the values below it, interpolated between its neighbors.
double quantile(std::vector<double> values, double share) {
  std::ranges::sort(values);
  const double rank = share * static_cast<double>(values.size() - 1);
  const auto below = static_cast<std::size_t>(rank);
  const auto above = std::min(below + 1, values.size() - 1);
  return std::lerp(values[below], values[above], rank - std::floor(rank));
}

/// "hours: 14 reported, median 7, quartiles 6 and 9.5; 1 unusable"; empty if there are none.
std::string reported_hours(const LabStatistics& lab) {
  if (lab.hours.empty() && lab.unusable_hours == 0) return {};
  std::string all = fmt::format("hours: {} reported", lab.hours.size());
  if (!lab.hours.empty()) {
    all += fmt::format(", median {:.3g}, quartiles {:.3g} and {:.3g}", quantile(lab.hours, 0.5),
                       quantile(lab.hours, 0.25), quantile(lab.hours, 0.75));
  }
  if (lab.unusable_hours > 0) all += fmt::format("; {} unusable", lab.unusable_hours);
  return all;
}

}  // namespace

ClassStatistics statistics_of(const Table& table, const std::map<std::string, Verdict>& verdicts,
                              const std::vector<Lab>& labs) {
  ClassStatistics statistics;
  statistics.submissions = table.rows.size();
  for (const Lab& lab : labs) {
    bool is_graded = false;
    std::vector<std::string> checks;
    for (const std::string& column : table.columns) {
      const Lab* const owner = lab_of_column(labs, column);
      if (owner == nullptr || owner->name != lab.name) continue;
      is_graded = true;
      if (is_check_column(column)) checks.push_back(column);
    }
    if (is_graded) statistics.labs.push_back(lab_statistics(table, verdicts, lab, checks));
  }
  std::map<std::string, std::size_t> hints;
  for (const Row& row : table.rows) {
    const auto verdict = verdicts.find(field(row, "id"));
    if (verdict == verdicts.end()) {
      ++statistics.without_verdict;
      continue;
    }
    for (const std::string& hint : hints_of(verdict->second)) ++hints[hint];
  }
  for (const auto& [hint, count] : hints) statistics.hints.push_back({hint, count});
  std::ranges::stable_sort(statistics.hints,
                           [](auto& a, auto& b) { return a.submissions > b.submissions; });
  constexpr std::size_t most_hints = 15;
  if (statistics.hints.size() > most_hints) statistics.hints.resize(most_hints);
  return statistics;
}

std::optional<double> point_biserial(const std::vector<bool>& yes,
                                     const std::vector<double>& number) {
  double sums[2] = {}, counts[2] = {};
  for (std::size_t i = 0; i < number.size(); ++i) {
    sums[yes[i]] += number[i];
    ++counts[yes[i]];
  }
  if (counts[0] == 0 || counts[1] == 0) return {};
  const auto [least, most] = std::ranges::minmax_element(number);
  if (*least == *most) return {};
  const double n = counts[0] + counts[1], mean = (sums[0] + sums[1]) / n;
  double squares = 0;
  for (const double one : number) squares += (one - mean) * (one - mean);
  // (M1 - M0) / s * sqrt(p q), with the standard deviation s over n.
  return (sums[1] / counts[1] - sums[0] / counts[0]) * std::sqrt(counts[0] * counts[1] / n) /
         std::sqrt(squares);
}

std::optional<double> task_points_in(const Table& table, const Row& row,
                                     const TaskStatistics& task) {
  std::optional<double> sum;
  for (const std::string& check : task.checks) {
    if (const auto earned = points_in(table, row, check)) sum = sum.value_or(0) + *earned;
  }
  return sum;
}

std::vector<PointsBar> histogram_of(const std::vector<double>& totals, double points) {
  std::vector<PointsBar> bars;
  for (int i = 0; i < 10; ++i) bars.push_back({fmt::format("{:g}+", i * points / 10), 0});
  bars.push_back({fmt::format("{:g}", points), 0});
  bars.push_back({fmt::format(">{:g}", points), 0});
  for (const double total : totals) {
    const double bar = total > points ? 11 : std::clamp(std::floor(10 * total / points), 0.0, 10.0);
    ++bars[static_cast<std::size_t>(bar)].submissions;
  }
  return bars;
}

std::string other_submissions(const LabStatistics& lab) {
  std::string all;
  const std::pair<std::size_t, const char*> kinds[] = {{lab.not_attempted, "not attempted"},
                                                       {lab.not_compiled, "not compiling"},
                                                       {lab.not_judged, "not judged"}};
  for (const auto& [count, what] : kinds) {
    if (count > 0) all += fmt::format("{}{} {}", all.empty() ? "" : ", ", count, what);
  }
  return all;
}

std::string center_of(const std::vector<double>& totals) {
  if (totals.empty()) return {};
  return fmt::format(
      "mean {:.1f}, median {:g}",
      std::accumulate(totals.begin(), totals.end(), 0.0) / static_cast<double>(totals.size()),
      quantile(totals, 0.5));
}

std::vector<std::string> summary_of(const LabStatistics& lab) {
  const std::string center = center_of(lab.totals);
  std::vector<std::string> lines{
      fmt::format("{} attempts{}", lab.totals.size(), center.empty() ? "" : "; " + center),
      other_submissions(lab), reported_hours(lab)};
  std::erase(lines, "");
  return lines;
}

}  // namespace mc::grader
