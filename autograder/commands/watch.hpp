#pragma once
// check --watch and demo --watch: judge or measure again whenever a file is saved.

#include <atomic>
#include <functional>

#include "commands/command.hpp"
#include "judge/reports/report.hpp"

namespace mc::grader {

/// Ends soon after `stop` becomes true. Returns what to show.
using Job = std::function<std::string(const std::atomic<bool>& stop)>;

/// Runs a command of ./lab, which finds this terminal by watching_terminal().
Job job_of(std::vector<std::string> command);

struct WatchedWork {
  std::vector<fs::path> files = {};
  /// What to do, in order; asked for after each save. What comes first is shown first.
  std::function<std::vector<Job>()> jobs;
  std::string subject, doing = "judging", done = "judged";  ///< "judging variance.cpp"
};

/// Does the jobs at once and after each save of one of the files, until interrupted. A save stops a
/// job in progress. Returns the exit status: 0.
int watch(const WatchedWork& work);

/// The terminal of the `watch` that started this program; nothing if it was started otherwise.
std::optional<Terminal> watching_terminal();

/// The report for repeated looks: points, the first open task, then the rest.
std::string report_open_first(const LabVerdict& lab, const Verdict& verdict,
                              const Terminal& terminal);

/// The first `rows` rows of a text in a window of that many columns; if lines are left out, the
/// last row says how many.
std::string first_rows(const std::string& text, std::size_t rows, std::size_t columns);

}  // namespace mc::grader
