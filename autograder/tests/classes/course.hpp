#pragma once
// A class of small submissions of lab 1, and ./lab as a grader uses it.

#include <map>

#include "judge/reports/csv.hpp"
#include "tests/submissions.hpp"

namespace mc::tests {

/// The rows of a table of grades by id; each row by column.
using Rows = std::map<std::string, std::map<std::string, std::string>>;
inline Rows rows_of(const fs::path& csv) {
  const auto table = csv_rows(read_whole_text(csv));
  Rows rows;
  for (std::size_t i = 1; i < table.size(); ++i) {
    REQUIRE(table[i].size() == table[0].size());
    REQUIRE_FALSE(rows.contains(table[i][0]));  // each id once
    for (std::size_t k = 0; k < table[i].size(); ++k) rows[table[i][0]][table[0][k]] = table[i][k];
  }
  return rows;
}

struct Course : Scratch {
  Layout layout = read_layout();
  std::vector<Lab> labs = find_labs(layout);
  std::vector<std::string> ids;

  void hand_in(const std::string& id, const std::string& text) {
    write("class/" + id + "/variance.cpp", text);
    ids.push_back(id);
  }
  /// Cheap submissions: most do not compile, a few are the starter.
  void hand_in_tiny(int count) {
    for (int i = 0; i < count; ++i) {
      const std::string id = fmt::format("s{:02}", i);
      hand_in(id, i % 5 == 0 ? fmt::format("// {}\n", i) + text_of(layout.starter())
                             : fmt::format("int {} is no name;\n", i));
    }
  }
  fs::path place() const { return path() / "class"; }
  fs::path csv(const std::string& name = "grades") const { return path() / (name + ".csv"); }
  fs::path verdict_file(const std::string& id) const {
    return path() / "grades-verdicts" / (id + ".json");
  }

  /// Runs a command that must succeed: its output.
  std::string output_of(const Words& words) const {
    REQUIRE_RUN(done, lab(words));
    return done.output;
  }
  /// The table of a run that must succeed.
  Rows graded(const Words& more) const {
    REQUIRE_RUN(done, grade(joined({"--csv", csv()}, more)));
    return rows_of(csv());
  }
  sandbox::ProcessResult grade(const Words& more,
                               const sandbox::ProcessOptions& options = {}) const {
    return lab(joined({"grade", "--class", place(), "--lab", "variance"}, more), options);
  }
};

}  // namespace mc::tests
