#pragma once
// The table of grades: a header that is fixed before the first row, and a row for each submission.

#include <string>
#include <string_view>
#include <vector>

#include "grader/judging/verdict.hpp"

namespace mc::grader {

/// The columns of a lab: its status, its total, and one for each check.
struct LabColumns {
  Lab lab;
  std::vector<std::string> checks;
};

/// Lines, with their ends. A row of what was not judged has the reason and no number.
std::string csv_header(const std::vector<LabColumns>& labs);
std::string csv_row(const std::vector<LabColumns>& labs, const Verdict& verdict);

/// A field of a CSV table: quoted where needed, and never a formula for a spreadsheet.
std::string csv_field(const std::string& text);

/// A table as rows of fields, formulas made harmless by csv_field() as they were before. Lines may
/// end as on Windows.
std::vector<std::vector<std::string>> csv_rows(std::string_view table);

}  // namespace mc::grader
