#pragma once
// Traces every number of a class's page to the files that it comes from: the table of grades and
// the verdicts next to it.

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "checks/support/catch.hpp"
#include "grader/checkout/labs.hpp"
#include "grader/gradebook/book.hpp"
#include "grader/gradebook/table.hpp"
#include "grader/reports/html.hpp"
#include "runner/text.hpp"
#include "tests/text.hpp"

namespace mc::tests {

using Cells = std::vector<std::vector<std::string>>;
using grader::field;

/// The table that begins after `from` in a page, without its header: the text of each cell, up to a
/// line break.
inline Cells cells_after(const std::string& page, const std::string& from) {
  CAPTURE(from);
  const auto begin = page.find("<table>", page.find(from));
  REQUIRE(begin != std::string::npos);
  std::string_view rest(page);
  rest = rest.substr(begin, page.find("</table>", begin) - begin);
  Cells rows;
  bool in_cell = false;
  for (; !rest.empty();) {
    const auto length = rest[0] == '<' ? rest.find('>') + 1 : 1;
    const std::string_view tag = rest.substr(0, length);
    if (tag == "<tr>") rows.emplace_back();
    if (tag.starts_with("<td") || tag.starts_with("<th")) rows.back().emplace_back();
    if (tag.starts_with("<td") || tag.starts_with("<th")) in_cell = true;
    if (tag.starts_with("</t") || tag == "<br>" || tag == "<pre>") in_cell = false;
    if (in_cell && length == 1) rows.back().back() += tag;
    rest.remove_prefix(length);
  }
  rows.erase(rows.begin());
  return rows;
}

/// What the files of a class say.
struct ClassFiles {
  using Row = grader::Row;
  grader::Table table;
  std::vector<grader::Verdict> verdicts;  ///< in the order of the rows
  std::map<std::string, double> points;   ///< of each check

  explicit ClassFiles(const std::filesystem::path& csv) : table(grader::read_table(csv)) {
    for (const Row& row : table.rows) {
      const auto verdict = grader::read_verdict(csv, field(row, "id"));
      REQUIRE(verdict);
      verdicts.push_back(*verdict);
      for (const auto& lab : verdict->labs) {
        for (const auto& result : lab.checks) points[result.check.name] = result.check.points;
      }
    }
  }
  std::vector<std::string> checks_of(const std::string& task_or_lab) const {
    std::vector<std::string> all;
    for (const std::string& column : table.columns) {
      if (grader::is_check_column(column) && column.starts_with(task_or_lab)) all.push_back(column);
    }
    return all;
  }
  static double number(const Row& row, const std::string& column) {
    const std::string text = field(row, column);
    return text.empty() ? 0 : std::stod(text);
  }
  double earned(const Row& row, const std::vector<std::string>& checks) const {
    double sum = 0;
    for (const std::string& check : checks) sum += number(row, check);
    return sum;
  }
  double possible(const std::vector<std::string>& checks) const {
    double sum = 0;
    for (const std::string& check : checks) sum += points.at(check);
    return sum;
  }
  /// The status of each check of a lab in a verdict.
  static std::map<std::string, grader::Status> results(const grader::Verdict& verdict,
                                                       const std::string& lab) {
    std::map<std::string, grader::Status> all;
    for (const auto& one : verdict.labs) {
      if (one.lab.name != lab) continue;
      for (const auto& result : one.checks) all[result.check.name] = result.status;
    }
    return all;
  }
};

/// The correlation of two lists by its definition, as the page shows it.
inline std::string correlation(const std::vector<double>& x, const std::vector<double>& y) {
  double sx = 0, sy = 0, sxx = 0, syy = 0, sxy = 0;
  const auto n = static_cast<double>(x.size());
  for (std::size_t i = 0; i < x.size(); ++i) sx += x[i] / n, sy += y[i] / n;
  for (std::size_t i = 0; i < x.size(); ++i) {
    sxx += (x[i] - sx) * (x[i] - sx);
    syy += (y[i] - sy) * (y[i] - sy);
    sxy += (x[i] - sx) * (y[i] - sy);
  }
  return sxx * syy < 1e-9 ? "-" : fmt::format("{:.2f}", sxy / std::sqrt(sxx * syy));
}

/// The section of one lab.
inline void check_numbers_of_lab(const std::string& page, const ClassFiles& files,
                                 const grader::Lab& lab) {
  using grader::Status;
  const std::vector<std::string> checks = files.checks_of(fmt::format("{}.", lab.number));
  std::vector<double> totals;
  std::vector<std::size_t> attempts;  // with a program
  std::map<std::string, std::size_t> others;
  for (std::size_t i = 0; i < files.verdicts.size(); ++i) {
    const grader::Row& row = files.table.rows[i];
    const double total = ClassFiles::number(row, lab.name + " total");
    const std::string status = field(row, lab.name + " status");
    const auto results = ClassFiles::results(files.verdicts[i], lab.name);
    const bool has_program = status.starts_with("judged");
    const bool has_begun = std::any_of(results.begin(), results.end(), [](const auto& one) {
      return one.second != Status::not_written;
    });
    if (total > 0 || (has_program && has_begun)) {
      totals.push_back(total);
      if (has_program) attempts.push_back(i);
    } else {
      ++others[status == "no program"                             ? "2 not compiling"
               : status == "unreadable" || status == "not judged" ? "3 not judged"
                                                                  : "1 not attempted"];
    }
  }
  std::sort(totals.begin(), totals.end());
  std::string text = fmt::format("<h2>{}</h2>\n<p>{} attempts", lab.title(), totals.size());
  double sum = 0;
  for (const double total : totals) sum += total;
  const std::size_t n = totals.size();
  if (n > 0) {
    text += fmt::format("; mean {:.1f}, median {:g}", sum / static_cast<double>(n),
                        (totals[(n - 1) / 2] + totals[n / 2]) / 2);
  }
  for (const auto& [kind, count] : others) {
    text += fmt::format("{}{} {}", kind == others.begin()->first ? "<br>" : ", ", count,
                        kind.substr(2));
  }
  CHECK(contains(page, text + "</p>"));

  const double all = files.possible(checks);
  Cells bars;
  for (int bar = 0; bar < 12; ++bar) {
    const double from = bar * all / 10, to = bar < 10 ? from + all / 10 : from;
    const auto is_in = [&](double x) {
      return bar == 11 ? x > all : bar == 10 ? x == all : x >= from && x < to;
    };
    bars.push_back({bar == 11   ? fmt::format("&gt;{:g}", all)
                    : bar == 10 ? fmt::format("{:g}", all)
                                : fmt::format("{:g}+", from),
                    std::to_string(std::count_if(totals.begin(), totals.end(), is_in)), ""});
  }
  CHECK(cells_after(page, "<h2>" + lab.title()) == bars);

  Cells tasks, outcomes;
  for (const std::string& check : checks) {
    const std::string task = check.substr(0, check.find(' '));
    const auto of_task = files.checks_of(task + ' ');
    if (tasks.empty() || tasks.back()[0] != task) {
      double earned = 0;
      std::size_t complete = 0;
      for (const std::size_t i : attempts) {
        const double one = files.earned(files.table.rows[i], of_task);
        earned += one;
        complete += one >= files.possible(of_task);
      }
      const double most = files.possible(of_task) * static_cast<double>(attempts.size());
      tasks.push_back({task, fmt::format("{:.0f} %", most > 0 ? 100 * earned / most : 0),
                       std::to_string(complete)});
    }
    std::size_t counts[5] = {};
    std::vector<double> passed, rest;
    for (const std::size_t i : attempts) {
      const grader::Row& row = files.table.rows[i];
      const Status status = ClassFiles::results(files.verdicts[i], lab.name).at(check);
      const double earned = ClassFiles::number(row, check);
      ++counts[earned > 0                      ? 0
               : status == Status::waiting     ? 2
               : status == Status::withheld    ? 3
               : status == Status::not_written ? 4
                                               : 1];
      passed.push_back(earned > 0);
      rest.push_back(files.earned(row, checks) - earned);
    }
    outcomes.push_back({grader::html_escaped(check)});
    for (const std::size_t count : counts) outcomes.back().push_back(std::to_string(count));
    outcomes.back().push_back(correlation(passed, rest));
  }
  CHECK(cells_after(page, "aria-label=\"" + lab.title() + ": tasks\"") == tasks);
  CHECK(cells_after(page, "aria-label=\"" + lab.title() + ": checks\"") == outcomes);
}

/// The page's submissions, map, statistics and hints, computed again from the files.
inline void check_numbers_of_class(const std::string& page, const std::filesystem::path& csv) {
  const ClassFiles files(csv);
  std::vector<grader::Lab> labs = grader::find_labs(grader::read_layout());
  std::erase_if(labs, [&](const grader::Lab& lab) {
    return files.checks_of(fmt::format("{}.", lab.number)).empty();
  });
  CHECK(contains(page, fmt::format("<p>{} submissions</p>", files.table.rows.size())));
  Cells submissions, map;
  for (const grader::Row& row : files.table.rows) {
    const std::string name = grader::html_escaped(field(row, "id"));
    submissions.push_back({name + (field(row, "late").empty() ? "" : " LATE")});
    map.push_back({name});
    for (const grader::Lab& lab : labs) {
      const std::string total = field(row, lab.name + " total");
      const std::string status = field(row, lab.name + " status");
      submissions.back().push_back(total.empty()        ? status
                                   : status == "judged" ? total
                                                        : total + " (" + status + ')');
      std::set<int> tasks;
      for (const std::string& check : files.checks_of(fmt::format("{}.", lab.number))) {
        if (!tasks.insert(std::stoi(check.substr(check.find('.') + 1))).second) continue;
        const auto of_task = files.checks_of(check.substr(0, check.find(' ') + 1));
        const double share = files.earned(row, of_task) / files.possible(of_task);
        map.back().push_back(field(row, check).empty() ? "" : fmt::format("{:.0f}", 100 * share));
      }
    }
  }
  CHECK(cells_after(page, "aria-label=\"submissions\"") == submissions);
  CHECK(cells_after(page, "aria-label=\"submissions and tasks\"") == map);
  for (const grader::Lab& lab : labs) check_numbers_of_lab(page, files, lab);

  std::map<std::string, std::set<std::string>> hints;
  for (const grader::Verdict& verdict : files.verdicts) {
    for (const auto& lab : verdict.labs) {
      for (const auto& result : lab.checks) {
        for (const std::string_view line : text::split(result.report, '\n')) {
          const bool is_hint =
              result.status == grader::Status::failed && line.starts_with("likely    ");
          if (is_hint) {
            hints[grader::html_escaped(line.substr(10))].insert(verdict.submission);
          }
        }
      }
    }
  }
  if (hints.empty()) return;
  for (const auto& row : cells_after(page, "aria-label=\"hints\"")) {
    CAPTURE(row[0]);
    CHECK(row[1] == std::to_string(hints[row[0]].size()));
  }
}

}  // namespace mc::tests
