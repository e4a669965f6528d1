#include <algorithm>
#include <map>
#include <utility>

#include <fmt/format.h>

#include "grader/reports/report.hpp"

namespace mc::grader {
namespace {

std::string csv_quoted(const std::string& text) {
  std::string all = "\"";
  for (const char c : text) all += c == '"' ? "\"\"" : std::string(1, c);
  return all + '"';
}

}  // namespace

std::string report_csv(const std::vector<Verdict>& verdicts) {
  // A column for each check that any verdict has, in the order of first appearance.
  std::vector<std::string> columns;
  for (const Verdict& verdict : verdicts) {
    for (const LabVerdict& lab : verdict.labs) {
      for (const CheckResult& result : lab.checks) {
        if (std::find(columns.begin(), columns.end(), result.check.name) == columns.end()) {
          columns.push_back(result.check.name);
        }
      }
    }
  }
  std::string all = "submission,seed,version,jail_complete,earned,points";
  for (const std::string& column : columns) all += ',' + csv_quoted(column);
  all += '\n';
  for (const Verdict& verdict : verdicts) {
    std::map<std::string, double> earned;
    for (const LabVerdict& lab : verdict.labs) {
      for (const CheckResult& result : lab.checks) earned[result.check.name] = result.earned();
    }
    all += fmt::format("{},{},{},{},{:g},{:g}", csv_quoted(verdict.submission), verdict.seed,
                       csv_quoted(verdict.version), verdict.jail_complete, verdict.earned(),
                       verdict.points());
    for (const std::string& column : columns) {
      const auto found = earned.find(column);
      all += found == earned.end() ? "," : fmt::format(",{:g}", found->second);
    }
    all += '\n';
  }
  return all;
}

}  // namespace mc::grader
