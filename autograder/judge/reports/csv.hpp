#pragma once
// CSV: the table of grades, and reading of tables.

#include <string>
#include <string_view>
#include <vector>

#include "judge/judging/verdict.hpp"

namespace mc::grader {

/// The columns of a lab: its status, its total, and one per check.
struct LabColumns {
  Lab lab;
  std::vector<std::string> checks;
};

/// A header and a row for each submission: id, seed, version, seconds, reason, the labs' states and
/// totals, the checks' points. What was not judged has the reason and no points.
std::string grade_table(const std::vector<LabColumns>& labs, const std::vector<Verdict>& verdicts);

/// Why the submission has no points, or fewer than it might: "unreadable: …", "no variance.cpp;
/// there is: variance (1).cpp"; empty if there is nothing to say.
std::string reason_of(const Verdict& verdict);

/// A field of a CSV table: quoted where needed, and never a formula for a spreadsheet.
std::string csv_field(const std::string& text);

/// Parses a table into rows of fields; undoes csv_field()'s protection of formulas. Accepts Windows
/// line ends and a byte order mark.
std::vector<std::vector<std::string>> csv_rows(std::string_view table);

}  // namespace mc::grader
