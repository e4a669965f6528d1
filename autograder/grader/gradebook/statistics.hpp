#pragma once
// What a table of grades says of the class and of the checks.

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "grader/gradebook/table.hpp"

namespace mc::grader {

/// How a check went, by the number of submissions.
struct CheckStatistics {
  std::string name;
  std::size_t passed = 0;
  std::size_t failed = 0;       ///< no points, whatever was written: wrong, waiting, not compiled
  std::size_t not_written = 0;  ///< no points: the task throws mc::todo, or there is no file
  std::size_t not_judged = 0;   ///< no grade: the machine failed, or nothing could be read
  /// The point-biserial correlation of passing it with the points of the lab's other checks, over
  /// submissions with points. Near 0 it does not discriminate; below 0 the better ones fail it.
  std::optional<double> discrimination;  ///< nothing where all pass, all fail, or the rest is equal
};

struct LabStatistics {
  Lab lab;
  std::vector<double> totals;  ///< of those who have points, in the order of the rows
  std::size_t not_judged = 0;  ///< how many have none, though they were to be judged
  std::vector<CheckStatistics> checks;
};

struct HintStatistics {
  std::string hint;
  std::size_t submissions = 0;  ///< to which it was given, in one check or in several
};

struct ClassStatistics {
  std::size_t submissions = 0;
  std::size_t without_verdict = 0;  ///< of them: what they did not write counts as failed
  std::vector<LabStatistics> labs;
  std::vector<HintStatistics> hints;  ///< the most frequent first
};

/// Points come from the table, where an instructor may have corrected them. Verdicts, by id, say
/// what was not written and which hints were given. Throws UsageError if points are not a number.
ClassStatistics statistics_of(const Table& table, const std::map<std::string, Verdict>& verdicts,
                              const std::vector<Lab>& labs);

/// The correlation of yes or no with a number, -1 to 1. Nothing where one of the two never changes.
std::optional<double> point_biserial(const std::vector<bool>& yes,
                                     const std::vector<double>& number);

/// A range of a lab's 100 points, "20-29", and how many submissions are in it.
struct PointsBar {
  std::string range;
  std::size_t submissions = 0;
};
/// Ten of ten points each, and "100".
std::vector<PointsBar> histogram_of(const std::vector<double>& totals);

/// "mean 41.2, median 38"; empty for no totals.
std::string centre_of(const std::vector<double>& totals);

/// For a terminal of 80 columns and more.
std::string report_statistics(const ClassStatistics& statistics);

/// So many hints are shown.
inline constexpr std::size_t most_hints = 15;

}  // namespace mc::grader
