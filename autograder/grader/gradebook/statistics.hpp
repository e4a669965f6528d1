#pragma once
// Statistics of a table of grades, for the class and for the checks.

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "grader/gradebook/table.hpp"

namespace mc::grader {

/// The outcomes of a check, as numbers of submissions.
struct CheckStatistics {
  std::string name;
  std::size_t passed = 0;
  std::size_t failed = 0;       ///< no points for what was written: wrong, waiting, not compiled
  std::size_t not_written = 0;  ///< no points: the task throws mc::todo, or there is no file
  std::size_t not_judged = 0;   ///< no grade: the machine failed, or the files are unreadable
  /// The point-biserial correlation of passing it with the points of the lab's other checks, over
  /// submissions with points. Near 0 it does not discriminate; below 0 the better ones fail it.
  std::optional<double> discrimination;  ///< nothing if all pass, all fail, or the rest is equal
};

struct LabStatistics {
  Lab lab;
  std::vector<double> totals;  ///< of submissions with points, in the order of the rows
  std::size_t not_judged = 0;  ///< submissions without points, though they were to be judged
  std::vector<CheckStatistics> checks;
};

struct HintStatistics {
  std::string hint;
  std::size_t submissions = 0;  ///< number that got it, in one check or in several
};

struct ClassStatistics {
  std::size_t submissions = 0;
  std::size_t without_verdict = 0;  ///< of these: their unwritten tasks count as failed
  std::vector<LabStatistics> labs;
  std::vector<HintStatistics> hints;  ///< most frequent first
};

/// Points come from the table, where an instructor may have corrected them. Verdicts, by id, say
/// what was not written and which hints were given. Throws UsageError if points are not a number.
ClassStatistics statistics_of(const Table& table, const std::map<std::string, Verdict>& verdicts,
                              const std::vector<Lab>& labs);

/// The correlation of a yes/no value with a number, -1 to 1. Nothing if one of them is constant.
std::optional<double> point_biserial(const std::vector<bool>& yes,
                                     const std::vector<double>& number);

/// A range of a lab's 100 points, "20-29", and how many submissions are in it.
struct PointsBar {
  std::string range;
  std::size_t submissions = 0;
};
/// Ten bars of ten points each, and "100".
std::vector<PointsBar> histogram_of(const std::vector<double>& totals);

/// "mean 41.2, median 38"; empty for no totals.
std::string centre_of(const std::vector<double>& totals);

/// For a terminal of at least 80 columns.
std::string report_statistics(const ClassStatistics& statistics);

/// The number of hints shown.
inline constexpr std::size_t most_hints = 15;

}  // namespace mc::grader
