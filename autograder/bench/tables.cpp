// Small tables, from the labs' cases (measurements/support/bench_data.hpp, bench_table).

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "bench/bench.hpp"

namespace mc::grader {
namespace {

constexpr std::string_view prefix = "table ";

/// A cell whose relative error exceeds this shows the error too.
constexpr double uncertain = 0.15;

/// Names in their order of arrival.
void enlist(std::vector<std::string>& names, const std::string& name) {
  if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
}

/// Two significant digits: "0.00012" is 1.2e-4.
std::string figure(double value) {
  if (!(value > 0) || !std::isfinite(value)) return fmt::format("{}", value);
  const int power = static_cast<int>(std::floor(std::log10(value)));
  if (power >= -1) return fmt::format("{:.{}f}", value, std::max(0, 1 - power));
  const std::string digits = fmt::format("{:.1f}", value * std::pow(10, -power));
  return digits == "10.0" ? fmt::format("1.0e{}", power + 1) : fmt::format("{}e{}", digits, power);
}

struct Table {
  std::string title;
  std::vector<std::string> rows{}, columns{};
  std::map<std::pair<std::string, std::string>, std::string> cells{};
  double largest = 0;  ///< relative error of the cells that do not show their own

  std::string printed() const {
    std::string all = title;
    if (largest > 0) all += fmt::format(" (± {:.0f} % at most)", 100 * largest);
    all += fmt::format("\n\n| | {} |\n|---|", fmt::join(columns, " | "));
    for (std::size_t i = 0; i < columns.size(); ++i) all += "--:|";
    all += '\n';
    for (const std::string& row : rows) {
      all += fmt::format("| {} |", row);
      for (const std::string& column : columns) {
        const auto found = cells.find({row, column});
        all += found == cells.end() ? " |" : fmt::format(" {} |", found->second);
      }
      all += '\n';
    }
    return all;
  }
};

}  // namespace

std::string bench_tables(const Bench& bench) {
  std::vector<Table> tables;
  for (const BenchRow& cell : bench.rows) {
    if (!cell.kind.starts_with(prefix)) continue;
    const std::string title = cell.kind.substr(prefix.size());
    auto table = std::find_if(tables.begin(), tables.end(),
                              [&](const Table& one) { return one.title == title; });
    if (table == tables.end()) table = tables.insert(tables.end(), {title});
    // Exact values have no author.
    const bool without_name = cell.submission == "solutions" || cell.what.ends_with(", exact");
    const std::string row =
        without_name ? cell.what : fmt::format("{}, {}", cell.what, cell.submission);
    enlist(table->rows, row);
    enlist(table->columns, cell.on);
    std::string& shown = table->cells[{row, cell.on}];
    shown = figure(cell.value);
    if (cell.error > uncertain * cell.value) {
      shown += " ± " + figure(cell.error);
    } else if (!std::isnan(cell.error)) {
      table->largest = std::max(table->largest, cell.error / cell.value);
    }
  }
  std::string all;
  for (const Table& table : tables) all += (all.empty() ? "" : "\n") + table.printed();
  return all;
}

}  // namespace mc::grader
