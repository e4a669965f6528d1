#pragma once
// A table of grades that is read again: what csv.hpp wrote, as a file.

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "grader/judging/verdict.hpp"

namespace mc::grader {

/// The fields of a row by their columns; empty ones are not there.
using Row = std::map<std::string, std::string>;

struct Table {
  std::filesystem::path file;
  std::vector<std::string> columns;
  std::vector<Row> rows;
};

/// The field of this column; empty where there is none.
std::string field(const Row& row, const std::string& column);

/// Throws UsageError where there is no such file, and for what is no table of grades.
Table read_table(const std::filesystem::path& file);

/// As csv_header() and csv_row() would have written it.
std::string table_text(const Table& table);

struct MergeResult {
  Table table;
  /// Each id with the table that its row is from.
  std::map<std::string, std::filesystem::path> from;
  std::vector<std::string> differences;  ///< "the seeds differ: a.csv 7, b.csv 8"
};

/// The rows of all, in the order of their ids, under the columns of all: those of an unsharded run.
/// A row that two tables have alike is there once. Throws UsageError where they have different rows
/// for an id.
MergeResult merge_tables(const std::vector<Table>& tables, const std::vector<Lab>& labs);

/// The lab that a column is about, "variance total" or "1.3 …"; null for a column about none.
const Lab* lab_of_column(const std::vector<Lab>& labs, const std::string& column);

/// Is this the column of a check, "1.3 …"?
bool is_check_column(const std::string& column);

/// The verdicts next to the table that its rows were made from, by id.
std::map<std::string, Verdict> read_verdicts(const Table& table);

}  // namespace mc::grader
