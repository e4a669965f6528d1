// Small tables, from the labs' cases (BenchTable in measurements/support/bench_data.hpp).

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "bench/bench.hpp"
#include "bench/markdown.hpp"

namespace mc::grader {
namespace {

constexpr std::string_view prefix = "table ";

/// A cell whose relative error exceeds this shows the error too.
constexpr double uncertain = 0.15;

/// Two significant digits: "0.00012" is 1.2e-4.
std::string digits_of(double value) {
  if (!(value > 0) || !std::isfinite(value)) return fmt::format("{}", value);
  const int power = static_cast<int>(std::floor(std::log10(value)));
  if (power >= -1) return fmt::format("{:.{}f}", value, std::max(0, 1 - power));
  const std::string digits = fmt::format("{:.1f}", value * std::pow(10, -power));
  return digits == "10.0" ? fmt::format("1.0e{}", power + 1) : fmt::format("{}e{}", digits, power);
}

struct Table {
  std::string title;
  std::vector<std::string> rows{};
  Markdown cells{{""}};
  double largest = 0;  ///< relative error of the cells that do not show their own
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
    const std::size_t y = enlist(table->rows, row);
    if (y == table->cells.rows.size()) table->cells.rows.push_back({row});
    std::string& shown = table->cells.cell(y, cell.on);
    shown = digits_of(cell.value);
    if (cell.error > uncertain * cell.value) {
      shown += " ± " + digits_of(cell.error);
    } else if (!std::isnan(cell.error)) {
      table->largest = std::max(table->largest, cell.error / cell.value);
    }
  }
  std::string all;
  for (const Table& table : tables) {
    all += (all.empty() ? "" : "\n") + table.title;
    if (table.largest > 0) all += fmt::format(" (± {:.0f} % at most)", 100 * table.largest);
    all += "\n\n" + table.cells.text();
  }
  return all;
}

}  // namespace mc::grader
