#pragma once
// Points that an instructor changes by hand. They are in corrections.csv next to the table of
// grades, which no run writes and every run, merge, statistic and page applies:
//
//   id,what,points,comment
//   anna,variance,91,typo in the file name
//   anna,1.3 two passes keep their digits under a large mean,8,right idea
//   bob,variance written,17,
//
// `what` is a check (its points), a lab (its total, whatever the checks say), or a lab and
// "written" (points added to its total, for written questions).

#include "grader/gradebook/table.hpp"

namespace mc::grader {

struct Correction {
  std::string id, what;
  double points = 0;
  std::string comment;
};

/// The corrections next to this table; empty if there is no such file. Throws UsageError, naming
/// the line, for an entry that is not a correction of a lab or check.
std::vector<Correction> read_corrections(const std::filesystem::path& csv,
                                         const std::vector<Lab>& labs);

/// Sets the points and totals of the table, and a column "corrections" that lists the changes. A
/// lab's total is the sum of its checks and its written points, unless it is set itself; applying
/// the same corrections again changes nothing. Returns the corrections of ids that have no row.
std::vector<Correction> apply_corrections(Table& table, const std::vector<Correction>& corrections,
                                          const std::vector<Lab>& labs);

/// Reads the table with its corrections; reports those without a row on standard error.
Table read_corrected_table(const std::filesystem::path& csv, const std::vector<Lab>& labs);

}  // namespace mc::grader
