#pragma once
// Statistics of a table of grades, for the class and for the checks.

#include "grader/gradebook/table.hpp"

namespace mc::grader {

/// The outcomes of a check, as numbers of attempts.
struct CheckStatistics {
  std::string name;
  std::size_t passed = 0, wrong = 0;
  std::size_t waiting = 0;      ///< failed, and so did a task or a lab that it needs
  std::size_t withheld = 0;     ///< passed, but its task's main check did not
  std::size_t not_written = 0;  ///< the task throws mc::todo
  /// The point-biserial correlation of passing it with the points of the lab's other checks, over
  /// attempts. Near 0 it does not discriminate; below 0 the better ones fail it.
  std::optional<double> discrimination;  ///< nothing if all pass, all fail, or the rest is equal
};

struct TaskStatistics {
  std::string task;                 ///< "1.3"
  std::vector<std::string> checks;  ///< its columns
  double points = 0;                ///< of all its checks
  double share = 0;                 ///< of these points that attempts earn on average
  std::size_t complete = 0;         ///< attempts with all of them
};

/// An attempt at a lab is a submission with points, or one that compiles and has begun a task.
struct LabStatistics {
  Lab lab;
  double points = 100;            ///< of all checks
  std::vector<double> totals;     ///< of attempts, in the order of the rows
  std::size_t not_attempted = 0;  ///< no file, or nothing in it is written
  std::size_t not_compiled = 0;
  std::size_t not_judged = 0;      ///< the machine failed, or the files are unreadable
  std::vector<double> hours;       ///< reported, 0 to 200 each
  std::size_t unusable_hours = 0;  ///< anything else that was reported
  std::vector<CheckStatistics> checks;
  std::vector<TaskStatistics> tasks;
};

struct HintStatistics {
  std::string hint;
  std::size_t submissions = 0;  ///< number that got it, in one check or in several
};

struct ClassStatistics {
  std::size_t submissions = 0;
  std::size_t without_verdict = 0;  ///< of these: their unwritten tasks count as wrong
  std::vector<LabStatistics> labs;
  std::vector<HintStatistics> hints;  ///< the most frequent, in order
};

/// Points come from the table, where an instructor may have corrected them. Verdicts, by id, say
/// what was not written and which hints were given. Throws UsageError if points are not a number.
ClassStatistics statistics_of(const Table& table, const std::map<std::string, Verdict>& verdicts,
                              const std::vector<Lab>& labs);

/// The correlation of a yes/no value with a number, -1 to 1. Nothing if one of them is constant.
std::optional<double> point_biserial(const std::vector<bool>& yes,
                                     const std::vector<double>& number);

/// The points of a task in this row of a table; nothing if it has none.
std::optional<double> task_points_in(const Table& table, const Row& row,
                                     const TaskStatistics& task);

/// A range of a lab's points, "20+", and how many submissions are in it.
struct PointsBar {
  std::string range;
  std::size_t submissions = 0;
};
/// Ten bars of a tenth of the points each, all points, and more.
std::vector<PointsBar> histogram_of(const std::vector<double>& totals, double points = 100);

/// "2 not attempted, 1 not compiling"; empty if all are attempts.
std::string other_submissions(const LabStatistics& lab);

/// "mean 41.2, median 38"; empty for no totals.
std::string center_of(const std::vector<double>& totals);

/// Lines about the submissions: "14 attempts; mean 41.2, median 38", then others and hours, if any.
std::vector<std::string> summary_of(const LabStatistics& lab);

/// For a terminal of at least 80 columns.
std::string report_statistics(const ClassStatistics& statistics);

}  // namespace mc::grader
