#include "grader/gradebook/table.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <stdexcept>
#include <utility>

#include "grader/gradebook/book.hpp"
#include "runner/text.hpp"

namespace mc::grader {
namespace {

std::string shown(const fs::path& file) {
  return sandbox::printable_line(file.string());
}

/// "1" of "1.3 the variance …"; empty if it is not a check's name.
std::string_view lab_number(std::string_view column) {
  constexpr std::string_view digits = "0123456789";
  const auto dot = column.find_first_not_of(digits);
  if (dot == 0 || dot == std::string_view::npos || column[dot] != '.') return {};
  const auto end = column.find_first_not_of(digits, dot + 1);
  if (end == dot + 1 || end == std::string_view::npos || column[end] != ' ') return {};
  return column.substr(0, dot);
}

/// Sort key of a column: first what every row has, then labs, checks, and added columns.
std::pair<int, int> place_of(const std::vector<Lab>& labs, const std::string& column) {
  if (has_column(
          {"id", "seed", "version", "seconds", "reason", "name", "email", "submitted", "late"},
          column)) {
    return {0, 0};
  }
  const Lab* const lab = lab_of_column(labs, column);
  if (lab == nullptr) return {3, 0};
  return {is_check_column(column) ? 2 : 1, lab->number};
}

/// "the seeds differ: a.csv 7, b.csv 8"; nothing if all rows agree.
void report_difference(const std::vector<Table>& tables, const std::string& column,
                       std::vector<std::string>& differences) {
  std::set<std::string> all;
  std::vector<std::string> each;
  for (const Table& table : tables) {
    std::set<std::string> here;
    for (const Row& row : table.rows) here.insert(field(row, column));
    if (!here.empty())
      each.push_back(fmt::format("{} {}", shown(table.file), fmt::join(here, " and ")));
    all.merge(here);
  }
  if (all.size() < 2) return;
  differences.push_back(fmt::format("the {}s differ: {}", column, fmt::join(each, ", ")));
}

}  // namespace

std::string field(const Row& row, const std::string& column) {
  const auto found = row.find(column);
  return found == row.end() ? "" : found->second;
}

bool has_column(const std::vector<std::string>& columns, const std::string& column) {
  return std::ranges::find(columns, column) != columns.end();
}

void add_column(std::vector<std::string>& columns, const std::string& column) {
  if (!has_column(columns, column)) columns.push_back(column);
}

std::optional<double> finite_number(std::string_view text) {
  try {
    double value = 0;
    text::parse(text, value);
    if (std::isfinite(value)) return value;
  } catch (const std::invalid_argument&) {  // nothing
  }
  return {};
}

Table read_table(const fs::path& file) {
  if (!fs::exists(file) || fs::is_directory(file)) {
    throw UsageError("no such table: " + shown(file));
  }
  auto rows = csv_rows(read_whole_text(file));
  const auto is_no_table = [&](const std::string& why) {
    throw UsageError(fmt::format("{} is not a table of grades: {}", shown(file), why));
  };
  Table table{file, rows.empty() ? std::vector<std::string>() : std::move(rows[0]), {}};
  std::set<std::string> names;
  for (std::string& column : table.columns) {
    column = sandbox::printable_line(column);  // untrusted text that is shown
    if (!names.insert(column).second) {
      is_no_table(fmt::format("there are two columns '{}'", column));
    }
  }
  if (!names.contains("id")) is_no_table("it has no 'id' column");
  for (std::size_t i = 1; i < rows.size(); ++i) {
    if (rows[i].size() != table.columns.size()) {
      is_no_table(fmt::format("row {} has {} fields, but the header has {}", i + 1, rows[i].size(),
                              table.columns.size()));
    }
    Row row;
    for (std::size_t k = 0; k < rows[i].size(); ++k) {
      const std::string shown_field = sandbox::printable_line(rows[i][k]);
      if (!shown_field.empty()) row[table.columns[k]] = shown_field;
    }
    const std::string id = field(row, "id");
    if (id.empty() || id.find('/') != std::string::npos) {  // it is also a file name
      is_no_table(fmt::format("'{}' is not a valid id", id));
    }
    table.rows.push_back(std::move(row));
  }
  return table;
}

std::string table_text(const Table& table) {
  std::string text;
  const auto add_line = [&](auto field_of) {
    for (std::size_t i = 0; i < table.columns.size(); ++i) {
      text += (i > 0 ? "," : "") + csv_field(field_of(table.columns[i]));
    }
    text += '\n';
  };
  add_line([](const std::string& column) { return column; });
  for (const Row& row : table.rows) {
    add_line([&](const std::string& column) { return field(row, column); });
  }
  return text;
}

MergeResult merge_tables(const std::vector<Table>& tables, const std::vector<Lab>& labs) {
  MergeResult merged;
  auto& columns = merged.table.columns;
  std::map<std::string, Row> rows;
  for (const Table& table : tables) {
    for (const std::string& column : table.columns) add_column(columns, column);
    for (const Row& row : table.rows) {
      const std::string id = field(row, "id");
      const auto [before, is_new] = rows.emplace(id, row);
      const fs::path& first = merged.from.emplace(id, table.file).first->second;
      if (is_new || before->second == row) continue;
      throw UsageError(fmt::format("{} is in {} and in {}, with different rows: which one counts?",
                                   id, shown(first), shown(table.file)));
    }
  }
  std::ranges::stable_sort(columns,
                           [&](auto& a, auto& b) { return place_of(labs, a) < place_of(labs, b); });
  for (auto& [id, row] : rows) merged.table.rows.push_back(std::move(row));
  for (const char* column : {"version", "seed"}) {
    report_difference(tables, column, merged.differences);
  }
  return merged;
}

const Lab* lab_of_column(const std::vector<Lab>& labs, const std::string& column) {
  for (const Lab& lab : labs) {
    if (column == lab.name + " status" || column == lab.name + " total" ||
        column == lab.name + " hours" || lab_number(column) == std::to_string(lab.number)) {
      return &lab;
    }
  }
  return nullptr;
}

bool is_check_column(const std::string& column) {
  return !lab_number(column).empty();
}

std::map<std::string, Verdict> read_verdicts(const Table& table) {
  std::map<std::string, Verdict> verdicts;
  for (const Row& row : table.rows) {
    const std::string id = field(row, "id");
    auto verdict = read_verdict(table.file, id);
    if (!verdict || std::to_string(verdict->seed) != field(row, "seed") ||
        verdict->version != field(row, "version")) {
      continue;
    }
    verdicts.emplace(id, std::move(*verdict));
  }
  return verdicts;
}

}  // namespace mc::grader
