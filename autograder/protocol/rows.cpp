#include "protocol/rows.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <stdexcept>

#include "runner/text.hpp"

namespace mc::protocol {
namespace {

std::string quoted(const std::string& text) {
  std::string all = "\"";
  for (const char c : text) all += c == '"' ? "\"\"" : std::string(1, c);
  return all + '"';
}

std::vector<std::string> fields_of(std::string_view line) {
  std::vector<std::string> fields(1);
  bool is_quoted = false;
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (line[i] == '"' && is_quoted && line.substr(i + 1).starts_with('"')) {
      fields.back() += line[++i];
    } else if (line[i] == '"') {
      is_quoted = !is_quoted;
    } else if (line[i] == ',' && !is_quoted) {
      fields.emplace_back();
    } else {
      fields.back() += line[i];
    }
  }
  return fields;
}

}  // namespace

std::string line_of(const Row& row) {
  char numbers[128];
  std::snprintf(numbers, sizeof numbers, "%llu,%llu,%.6g,%.6g",
                static_cast<unsigned long long>(row.dimensions),
                static_cast<unsigned long long>(row.n), row.rmse, row.ns);
  return quoted(row.lab) + ',' + quoted(row.method) + ',' + quoted(row.task) + ',' +
         quoted(row.integrand) + ',' + numbers;
}

std::optional<Row> row_in(std::string_view line) {
  auto fields = fields_of(line);
  if (fields.size() != 8) return {};
  Row row{fields[0], fields[1], fields[2], fields[3]};
  try {
    text::parse(fields[4], row.dimensions);
    text::parse(fields[5], row.n);
    text::parse(fields[6], row.rmse);
    text::parse(fields[7], row.ns);
  } catch (const std::invalid_argument&) {
    return {};
  }
  return row;
}

std::vector<Row> rows_in(const std::filesystem::path& file) {
  std::vector<Row> rows;
  std::ifstream from(file);
  for (std::string line; std::getline(from, line);) {
    if (auto row = row_in(line)) rows.push_back(std::move(*row));
  }
  return rows;
}

std::vector<Comparison> comparisons_in(const std::vector<Row>& rows) {
  struct Times {
    std::string task, against;
    std::vector<double> ours{}, others{}, ratios{};
  };
  std::vector<Times> all;
  const Row* ours = nullptr;
  for (const Row& row : rows) {
    if (row.method.empty()) {
      ours = &row;
    } else if (ours != nullptr && ours->task == row.task) {
      auto found = std::ranges::find_if(
          all, [&](const Times& one) { return one.task == row.task && one.against == row.method; });
      if (found == all.end()) found = all.insert(found, {row.task, row.method});
      if (!std::isnan(ours->ns)) found->ours.push_back(ours->ns);
      if (!std::isnan(row.ns)) found->others.push_back(row.ns);
      if (!std::isnan(row.ns / ours->ns)) found->ratios.push_back(row.ns / ours->ns);
      ours = nullptr;
    }
  }
  const auto middle = [](std::vector<double>& values) {
    std::ranges::sort(values);
    return values.empty() ? unknown : values[values.size() / 2];
  };
  std::vector<Comparison> comparisons;
  for (Times& one : all) {
    comparisons.push_back(
        {one.task, one.against, middle(one.ours), middle(one.others), middle(one.ratios)});
    if (one.ratios.empty()) continue;
    comparisons.back().low = one.ratios.front();
    comparisons.back().high = one.ratios.back();
  }
  return comparisons;
}

}  // namespace mc::protocol
