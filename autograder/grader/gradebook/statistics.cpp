#include "grader/gradebook/statistics.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>
#include <stdexcept>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "grader/base/errors.hpp"
#include "runner/text.hpp"
#include "sandbox/printable.hpp"

namespace mc::grader {
namespace {

std::optional<double> points_in(const Table& table, const Row& row, const std::string& column) {
  const std::string text = field(row, column);
  if (text.empty()) return {};
  try {
    double value = 0;
    text::parse(text, value);
    if (std::isfinite(value)) return value;
  } catch (const std::invalid_argument&) {  // reported below
  }
  throw UsageError(fmt::format("{}: '{}' of {} is no number of points, in column '{}'",
                               sandbox::printable_line(table.file.string()), text, field(row, "id"),
                               column));
}

/// The reason in place of this row's cells of a lab, if it should have been judged but could not
/// be.
bool lacks_grade(const Row& row, const Lab& lab) {
  const std::string status = field(row, lab.name + " status");
  return status == "not judged" || status == "unreadable";
}

bool has_status(const Verdict& verdict, const std::string& check, Status status) {
  for (const LabVerdict& lab : verdict.labs) {
    for (const CheckResult& result : lab.checks) {
      if (result.check.name == check) return result.status == status;
    }
  }
  return false;
}

/// The rows with points in a lab: the points of each check, in the order of the columns.
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

LabStatistics lab_statistics(const Table& table, const std::map<std::string, Verdict>& verdicts,
                             const Lab& lab, const std::vector<std::string>& checks) {
  LabStatistics statistics{lab, {}, 0, {}};
  for (const std::string& check : checks) statistics.checks.push_back({check, 0, 0, 0, 0, {}});
  Points points;
  for (const Row& row : table.rows) {
    const bool lacks = lacks_grade(row, lab);
    const auto total = points_in(table, row, lab.name + " total");
    if (total) statistics.totals.push_back(*total);
    statistics.not_judged += !total && lacks;
    const auto verdict = verdicts.find(field(row, "id"));
    const bool has_file = field(row, lab.name + " status") != "no file";
    const auto has = [&](const std::string& check, Status status) {
      return verdict != verdicts.end() && has_status(verdict->second, check, status);
    };
    std::vector<std::optional<double>> of_row;
    for (CheckStatistics& check : statistics.checks) {
      const auto earned = points_in(table, row, check.name);
      of_row.push_back(earned);
      if (!earned) {
        check.not_judged += lacks;
      } else if (*earned > 0 || has(check.name, Status::passed)) {  // a check may have 0 points
        ++check.passed;
      } else if (!has_file || has(check.name, Status::not_written)) {
        ++check.not_written;
      } else {
        ++check.failed;
      }
    }
    if (total) points.push_back(std::move(of_row));
  }
  for (std::size_t i = 0; i < checks.size(); ++i) {
    statistics.checks[i].discrimination = discrimination_of(points, i);
  }
  return statistics;
}

/// The hints in the reports of failed checks, each once.
std::set<std::string> hints_of(const Verdict& verdict) {
  constexpr std::string_view label = "likely    ";
  std::set<std::string> hints;
  for (const LabVerdict& lab : verdict.labs) {
    for (const CheckResult& result : lab.checks) {
      if (result.status != Status::failed) continue;
      for (const std::string_view line : text::split(result.report, '\n')) {
        if (line.starts_with(label)) {
          hints.insert(sandbox::printable_line(line.substr(label.size())));
        }
      }
    }
  }
  return hints;
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
  std::stable_sort(statistics.hints.begin(), statistics.hints.end(),
                   [](auto& a, auto& b) { return a.submissions > b.submissions; });
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
  const auto [least, most] = std::minmax_element(number.begin(), number.end());
  if (*least == *most) return {};
  const double n = counts[0] + counts[1], mean = (sums[0] + sums[1]) / n;
  double squares = 0;
  for (const double one : number) squares += (one - mean) * (one - mean);
  // (M1 - M0) / s * sqrt(p q), with the standard deviation s over n.
  return (sums[1] / counts[1] - sums[0] / counts[0]) * std::sqrt(counts[0] * counts[1] / n) /
         std::sqrt(squares);
}

std::vector<PointsBar> histogram_of(const std::vector<double>& totals) {
  std::vector<PointsBar> bars;
  for (int i = 0; i < 10; ++i) bars.push_back({fmt::format("{}-{}", 10 * i, 10 * i + 9), 0});
  bars.push_back({"100", 0});
  for (const double total : totals) {
    ++bars[static_cast<std::size_t>(std::clamp(std::floor(total / 10), 0.0, 10.0))].submissions;
  }
  return bars;
}

std::string centre_of(const std::vector<double>& totals) {
  if (totals.empty()) return {};
  std::vector<double> sorted = totals;
  std::sort(sorted.begin(), sorted.end());
  const auto n = static_cast<double>(sorted.size());
  const double median = (sorted[(sorted.size() - 1) / 2] + sorted[sorted.size() / 2]) / 2;
  return fmt::format("mean {:.1f}, median {:g}",
                     std::accumulate(sorted.begin(), sorted.end(), 0.0) / n, median);
}

}  // namespace mc::grader
