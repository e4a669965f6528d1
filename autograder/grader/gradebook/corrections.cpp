#include "grader/gradebook/corrections.hpp"

#include <cstdlib>
#include <map>

#include "grader/submission/source.hpp"

namespace mc::grader {
namespace {

constexpr const char* note_column = "corrections";
constexpr std::string_view written = " written";

/// "variance total" for "variance", "1", and "variance written".
const Lab* lab_called(const std::vector<Lab>& labs, std::string_view what) {
  if (what.ends_with(written)) what.remove_suffix(written.size());
  for (const Lab& lab : labs) {
    if (what == lab.name || what == std::to_string(lab.number)) return &lab;
  }
  return nullptr;
}

double number_in(const Row& row, const std::string& column) {
  return std::strtod(field(row, column).c_str(), nullptr);
}

std::string text_of_points(double points) {
  return fmt::format("{:g}", points);
}

/// Sets one cell and notes its old value.
void set_points(Row& row, const std::string& column, const Correction& correction) {
  std::string note = fmt::format("{}: {:g}", correction.what, correction.points);
  if (!correction.comment.empty()) note += fmt::format(" ({})", correction.comment);
  std::string& all = row[note_column];
  all += (all.empty() ? "" : "; ") + note;
  row[column] = text_of_points(correction.points);
}

/// The sum of the lab's checks and its written points.
void add_up(const Table& table, Row& row, const std::vector<Lab>& labs, const Lab& lab) {
  double sum = number_in(row, lab.name + std::string(written));
  for (const std::string& column : table.columns) {
    if (!is_check_column(column)) continue;
    const Lab* const owner = lab_of_column(labs, column);
    if (owner != nullptr && owner->name == lab.name) sum += number_in(row, column);
  }
  row[lab.name + " total"] = text_of_points(sum);
}

}  // namespace

std::vector<Correction> read_corrections(const fs::path& csv, const std::vector<Lab>& labs) {
  const fs::path file = fs::absolute(csv).parent_path() / "corrections.csv";
  if (!fs::exists(file)) return {};
  const SourceFile source = read_source(file);
  const auto refuse = [&](std::size_t line, const std::string& why) {
    throw UsageError(
        fmt::format("{}, line {}: {}", sandbox::printable_line(file.string()), line, why));
  };
  if (!source.problem.empty()) throw UsageError(source.problem);
  std::vector<Correction> corrections;
  const auto rows = csv_rows(source.text);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const auto& row = rows[i];
    if (i == 0 && row[0] == "id") continue;
    if (row.size() < 3 || row.size() > 4) {
      refuse(i + 1, "a line must be id,what,points,comment");
    }
    const auto points = finite_number(row[2]);
    if (!points) {
      refuse(i + 1, fmt::format("'{}' is not a number of points", sandbox::printable_line(row[2])));
    }
    Correction one{row[0], row[1], *points, row.size() == 4 ? sandbox::printable_line(row[3]) : ""};
    if (!is_check_column(one.what) && lab_called(labs, one.what) == nullptr) {
      refuse(i + 1, fmt::format("'{}' is not a lab (variance), the written points of a lab "
                                "(variance written), nor a check (its column)",
                                sandbox::printable_line(one.what)));
    }
    corrections.push_back(std::move(one));
  }
  return corrections;
}

std::vector<Correction> apply_corrections(Table& table, const std::vector<Correction>& corrections,
                                          const std::vector<Lab>& labs) {
  if (corrections.empty()) return {};
  std::map<std::string, Row*> rows;
  add_column(table.columns, note_column);
  for (Row& row : table.rows) {
    rows[field(row, "id")] = &row;
    row.erase(note_column);
  }
  std::vector<Correction> without_row;
  std::vector<std::pair<Row*, Correction>> totals;
  for (const Correction& one : corrections) {
    const auto found = rows.find(one.id);
    if (found == rows.end()) {
      without_row.push_back(one);
      continue;
    }
    Row& row = *found->second;
    if (is_check_column(one.what)) {
      add_column(table.columns, one.what);
      set_points(row, one.what, one);
      if (const Lab* lab = lab_of_column(labs, one.what)) add_up(table, row, labs, *lab);
      continue;
    }
    const Lab& lab = *lab_called(labs, one.what);
    if (one.what.ends_with(written)) {
      add_column(table.columns, lab.name + std::string(written));
      set_points(row, lab.name + std::string(written), one);
      add_up(table, row, labs, lab);
    } else {
      totals.emplace_back(&row, one);
    }
  }
  for (const auto& [row, one] : totals) {  // after the sums
    const std::string column = lab_called(labs, one.what)->name + " total";
    add_column(table.columns, column);
    set_points(*row, column, one);
  }
  return without_row;
}

Table read_corrected_table(const fs::path& csv, const std::vector<Lab>& labs) {
  Table table = read_table(csv);
  for (const Correction& one : apply_corrections(table, read_corrections(csv, labs), labs)) {
    fmt::print(stderr, "corrections.csv: there is no submission '{}'\n",
               sandbox::printable_line(one.id));
  }
  return table;
}

}  // namespace mc::grader
