#pragma once
// Reads tables of grades back from the files that csv.hpp wrote. This header has what nearly every
// file of this folder needs.

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "grader/base/errors.hpp"
#include "grader/base/text_file.hpp"
#include "grader/checkout/labs.hpp"
#include "grader/judging/verdict.hpp"
#include "grader/reports/csv.hpp"
#include "sandbox/printable.hpp"

namespace mc::grader {
namespace fs = std::filesystem;

/// The fields of a row by their columns; empty ones are absent.
using Row = std::map<std::string, std::string>;

struct Table {
  fs::path file;
  std::vector<std::string> columns;
  std::vector<Row> rows;
};

/// The field of this column; empty if there is none.
std::string field(const Row& row, const std::string& column);

bool has_column(const std::vector<std::string>& columns, const std::string& column);
/// Adds it at the end, unless it exists.
void add_column(std::vector<std::string>& columns, const std::string& column);

/// The value of a text that is a finite number; nothing for other texts.
std::optional<double> finite_number(std::string_view text);

/// Throws UsageError if there is no such file, or if it is not a table of grades.
Table read_table(const fs::path& file);

/// The text that csv_header() and csv_row() would write.
std::string table_text(const Table& table);

struct MergeResult {
  Table table;
  /// The table that each id's row comes from.
  std::map<std::string, fs::path> from;
  std::vector<std::string> differences;  ///< "the seeds differ: a.csv 7, b.csv 8"
};

/// The rows of all tables, in the order of their ids, with the columns of all: the table of an
/// unsharded run. Rows that two tables share appear once. Throws UsageError for different rows with
/// the same id.
MergeResult merge_tables(const std::vector<Table>& tables, const std::vector<Lab>& labs);

/// The lab of a column such as "variance total" or "1.3 …"; null for other columns.
const Lab* lab_of_column(const std::vector<Lab>& labs, const std::string& column);

/// Is this the column of a check, "1.3 …"?
bool is_check_column(const std::string& column);

/// The verdicts next to the table that its rows were made from, by id.
std::map<std::string, Verdict> read_verdicts(const Table& table);

}  // namespace mc::grader
