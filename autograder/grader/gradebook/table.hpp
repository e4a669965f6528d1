#pragma once
// Reads tables of grades back from the files that csv.hpp wrote.

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "grader/judging/verdict.hpp"

namespace mc::grader {

/// The fields of a row by their columns; empty ones are absent.
using Row = std::map<std::string, std::string>;

struct Table {
  std::filesystem::path file;
  std::vector<std::string> columns;
  std::vector<Row> rows;
};

/// The field of this column; empty if there is none.
std::string field(const Row& row, const std::string& column);

/// Throws UsageError if there is no such file, or if it is not a table of grades.
Table read_table(const std::filesystem::path& file);

/// The text that csv_header() and csv_row() would write.
std::string table_text(const Table& table);

struct MergeResult {
  Table table;
  /// The table that each id's row comes from.
  std::map<std::string, std::filesystem::path> from;
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
