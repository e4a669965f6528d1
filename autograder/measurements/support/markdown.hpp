#pragma once
// A table as documents and terminals show it.

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

namespace mc {

/// Two significant digits: "0.00012" is 1.2e-4.
inline std::string two_digits(double value) {
  if (!(value > 0) || !std::isfinite(value)) return fmt::format("{}", value);
  const int power = static_cast<int>(std::floor(std::log10(value)));
  if (power >= -1) return fmt::format("{:.{}f}", value, std::max(0, 1 - power));
  const std::string digits = fmt::format("{:.1f}", value * std::pow(10, -power));
  return digits == "10.0" ? fmt::format("1.0e{}", power + 1) : fmt::format("{}e{}", digits, power);
}

/// The place of a name in a list, to which it is added if it is new.
inline std::size_t enlist(std::vector<std::string>& names, const std::string& name) {
  const auto found = std::find(names.begin(), names.end(), name);
  const auto place = static_cast<std::size_t>(found - names.begin());
  if (found == names.end()) names.push_back(name);
  return place;
}

class Markdown {
 public:
  /// The cell above the names of the rows_.
  explicit Markdown(std::string corner = {}) : headers_{std::move(corner)} {}

  /// The cell in this row and column, which are added if they are new.
  std::string& cell(const std::string& row, const std::string& header) {
    const std::size_t column = 1 + enlist(names_of_columns_, header);
    if (column == headers_.size()) headers_.push_back(header);
    const std::size_t y = enlist(names_of_rows_, row);
    if (y == rows_.size()) rows_.push_back({row});
    for (auto& cells : rows_) cells.resize(headers_.size());
    return rows_[y][column];
  }
  std::string text() const {
    std::string all = line_of(headers_) + "|---";
    for (std::size_t i = 1; i < headers_.size(); ++i) all += "|--:";
    all += "|\n";
    for (const auto& row : rows_) all += line_of(row);
    return all;
  }

 private:
  static std::string line_of(const std::vector<std::string>& cells) {
    std::string all;
    for (const std::string& cell : cells) all += cell.empty() ? "| " : "| " + cell + ' ';
    return all + "|\n";
  }
  std::vector<std::string> headers_, names_of_rows_, names_of_columns_;
  std::vector<std::vector<std::string>> rows_;  ///< the first cell of each is its name
};

}  // namespace mc
