#include "measurements/support/bench_data.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>

#include <fmt/format.h>

#include "measurements/support/markdown.hpp"
#include "protocol/environment.hpp"

namespace mc::measurements {
namespace {

/// A cell whose relative error exceeds this shows the error too.
constexpr double uncertain = 0.15;

struct Table {
  std::string title;
  Markdown cells{};
  double largest = 0;  ///< relative error of the cells that do not show their own
};

}  // namespace

double nanoseconds_of(const Rounds& rounds, Count n) {
  return seconds_of(rounds, 0.025, 3) * 1e9 / static_cast<double>(n);
}

void BenchTable::add(const std::string& row, const std::string& column, double value,
                     double error) const {
  static std::vector<Table> tables;
  if (std::isnan(value)) return;
  auto table = std::ranges::find(tables, title, &Table::title);
  if (table == tables.end()) table = tables.insert(table, {title});
  std::string& shown = table->cells.cell(row, column);
  shown = two_digits(value);
  if (error > uncertain * value) {
    shown += " ± " + two_digits(error);
  } else if (!std::isnan(error)) {
    table->largest = std::max(table->largest, error / value);
  }
  const char* const path = std::getenv(protocol::rows_variable);
  std::ofstream file(path == nullptr ? "" : path);
  for (const Table& one : tables) {
    file << (one.title == tables[0].title ? "" : "\n") << one.title;
    if (one.largest > 0) file << fmt::format(" (± {:.0f} % at most)", 100 * one.largest);
    file << "\n\n" << one.cells.text();
  }
}

}  // namespace mc::measurements
