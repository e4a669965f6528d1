#pragma once
// The table of grades: a fixed header, and a row for each submission.

#include <string>
#include <string_view>
#include <vector>

#include "grader/judging/verdict.hpp"

namespace mc::grader {

/// The columns of a lab: its status, its total, the hours that students report (if any does), and
/// one per check.
struct LabColumns {
  Lab lab;
  std::vector<std::string> checks;
  bool has_hours = false;
};

/// Lines with their line ends. A row that was not judged has the reason and no points. With people:
/// also their names, e-mail addresses, times of submission, and LATE marks.
enum class People { hidden, shown };
std::string csv_header(const std::vector<LabColumns>& labs, People people = People::hidden);
std::string csv_row(const std::vector<LabColumns>& labs, const Verdict& verdict,
                    People people = People::hidden);

/// A field of a CSV table: quoted where needed, and never a formula for a spreadsheet.
std::string csv_field(const std::string& text);

/// Parses a table into rows of fields; undoes csv_field()'s protection of formulas. Accepts Windows
/// line ends and a byte order mark.
std::vector<std::vector<std::string>> csv_rows(std::string_view table);

}  // namespace mc::grader
