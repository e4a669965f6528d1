// The statistics of a class, at a terminal.
#include <algorithm>

#include "grader/gradebook/statistics.hpp"
#include "grader/reports/report.hpp"

namespace mc::grader {
namespace {

constexpr std::size_t width = 80;

std::string histogram_text(const LabStatistics& lab) {
  constexpr std::size_t longest = 50;  // columns of the longest bar
  const auto bars = histogram_of(lab.totals, lab.points);
  std::size_t most = 1;
  for (const PointsBar& bar : bars) most = std::max(most, bar.submissions);
  std::string all;
  for (const PointsBar& bar : bars) {
    // One mark per submission if there is room. No submission is rounded away.
    const std::size_t length =
        most <= longest ? bar.submissions : (bar.submissions * longest + most - 1) / most;
    const std::string line =
        fmt::format("  {:>5}  {:>5}  {}", bar.range, bar.submissions, std::string(length, '#'));
    all += line.substr(0, line.find_last_not_of(' ') + 1) + '\n';
  }
  return all;
}

std::string checks_text(const std::vector<CheckStatistics>& checks) {
  constexpr std::size_t numbers = 55;  // columns before the name
  std::string all =
      "  passed   wrong  waiting    with-      not   discri-\n"
      "                              held  written  mination  check\n";
  for (const CheckStatistics& one : checks) {
    const std::string discrimination =
        one.discrimination ? fmt::format("{:.2f}", *one.discrimination) : "-";
    all += fmt::format("  {:>6}  {:>6}  {:>7}  {:>7}  {:>7}  {:>8}  {}\n", one.passed, one.wrong,
                       one.waiting, one.withheld, one.not_written, discrimination,
                       wrapped(one.name, width - numbers, numbers));
  }
  return all;
}

std::string tasks_text(const std::vector<TaskStatistics>& tasks) {
  std::string all = "  task   points earned  all points\n";
  for (const TaskStatistics& one : tasks) {
    all += fmt::format("  {:<6} {:>12.0f}%  {:>10}\n", one.task, 100 * one.share, one.complete);
  }
  return all;
}

}  // namespace

std::string report_statistics(const ClassStatistics& statistics) {
  std::string all = fmt::format("{} submissions\n", statistics.submissions);
  if (statistics.without_verdict > 0) {
    all +=
        wrapped(fmt::format("{} of them have no verdict next to the table: their unwritten tasks "
                            "count as wrong, and their hints are unknown.",
                            statistics.without_verdict),
                width, 0) +
        '\n';
  }
  for (const LabStatistics& one : statistics.labs) {
    all +=
        fmt::format("\n{}: {}\n\n{}\n{}\n{}", one.lab.title(), fmt::join(summary_of(one), "\n  "),
                    histogram_text(one), tasks_text(one.tasks), checks_text(one.checks));
  }
  if (!statistics.hints.empty()) all += "\nHints, by the submissions they were given to\n\n";
  for (const HintStatistics& one : statistics.hints) {
    all += fmt::format("  {:>6}  {}\n", one.submissions, wrapped(one.hint, width - 10, 10));
  }
  return all;
}

}  // namespace mc::grader
