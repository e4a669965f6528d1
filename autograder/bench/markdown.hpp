#pragma once
// A table as documents and terminals show it.

#include <algorithm>
#include <string>
#include <vector>

namespace mc::grader {

/// Adds a name to those in their order of arrival, if it is new; its place among them.
inline std::size_t enlist(std::vector<std::string>& names, const std::string& name) {
  const auto found = std::find(names.begin(), names.end(), name);
  const auto place = static_cast<std::size_t>(found - names.begin());
  if (found == names.end()) names.push_back(name);
  return place;
}

struct Markdown {
  std::vector<std::string> headers;
  std::size_t left = 1;  ///< columns of words; those behind them are numbers
  std::vector<std::vector<std::string>> rows{};

  /// A row's cell in the column with this header, which is added if it is new.
  std::string& cell(std::size_t row, const std::string& header) {
    const std::size_t column = enlist(headers, header);
    for (auto& cells : rows) cells.resize(headers.size());
    return rows[row][column];
  }
  std::string text() const {
    std::string all = line_of(headers);
    for (std::size_t i = 0; i < headers.size(); ++i) all += i < left ? "|---" : "|--:";
    all += "|\n";
    for (const auto& row : rows) all += line_of(row);
    return all;
  }

 private:
  static std::string line_of(const std::vector<std::string>& cells) {
    std::string all;
    for (const std::string& cell : cells) all += cell.empty() ? "| " : "| " + cell + ' ';
    return all + "|\n";
  }
};

}  // namespace mc::grader
