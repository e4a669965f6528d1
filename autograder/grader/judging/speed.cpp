#include "grader/judging/speed.hpp"

#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <map>
#include <set>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "grader/judging/judge.hpp"
#include "protocol/environment.hpp"
#include "protocol/rows.hpp"

namespace mc::grader {
namespace fs = std::filesystem;
namespace {

/// Measured right after the submission's own rows: the speed of a machine changes within minutes.
std::vector<protocol::Row> rows_of_reference(const Layout& layout, const Lab& lab,
                                             const std::set<std::string>& tasks,
                                             const sandbox::Program& program,
                                             const std::vector<protocol::Row>& own) {
  if (!fs::exists(layout.solutions() / lab.file())) return {};
  const Submission solutions = open_submission(find_labs(layout), layout.solutions());
  const BuildResult built = build_program(layout, lab, solutions);
  if (!built.program) return {};
  if (built.program->path == program.path) return own;  // it is the reference itself
  return speed_rows(layout, lab, *built.program, tasks);
}

const protocol::Row* find(const std::vector<protocol::Row>& rows, const std::string& kind,
                          const std::string& what) {
  for (const protocol::Row& row : rows) {
    if (row.kind == kind && row.what == what) return &row;
  }
  return nullptr;
}

}  // namespace

fs::path ratios_file(const Layout& layout, const Lab& lab) {
  return layout.labs() / lab.folder / "speed.tsv";
}

std::map<std::string, double> kept_ratios(const fs::path& file) {
  std::map<std::string, double> ratios;
  std::ifstream lines(file);
  for (std::string line; std::getline(lines, line);) {
    const auto tab = line.find('\t');
    if (line.starts_with('#') || tab == std::string::npos) continue;
    ratios[line.substr(0, tab)] = std::strtod(line.c_str() + tab + 1, nullptr);
  }
  return ratios;
}

std::vector<protocol::Row> speed_rows(const Layout& layout, const Lab& lab,
                                      const sandbox::Program& program,
                                      const std::set<std::string>& tasks) {
  const fs::path file = layout.build / "speed" / fmt::format("{}.{}.tsv", lab.name, getpid());
  fs::create_directories(file.parent_path());
  fs::remove(file);
  run_hidden_cases(
      layout, lab, CaseKind::checks, program, "[.speed]",
      {.environment = {{protocol::rows_variable, file.string()},
                       {protocol::speed_tasks_variable, fmt::format("{}", fmt::join(tasks, " "))}},
       .wall_seconds = 60});
  std::vector<protocol::Row> rows;
  std::ifstream written(file);
  for (std::string line; std::getline(written, line);) {
    if (auto row = protocol::row_in(line)) rows.push_back(std::move(*row));
  }
  fs::remove(file);
  return rows;
}

std::vector<Speed> measure_speed(const Layout& layout, const LabVerdict& verdict,
                                 const sandbox::Program& program) {
  std::set<std::string> passed;
  for (const CheckResult& result : verdict.checks) passed.insert(result.check.task);
  for (const CheckResult& result : verdict.checks) {
    if (result.status != Status::passed) passed.erase(result.check.task);
  }
  const auto own = speed_rows(layout, verdict.lab, program, passed);
  if (own.empty()) return {};
  const auto reference = rows_of_reference(layout, verdict.lab, passed, program, own);
  const auto ratios = kept_ratios(ratios_file(layout, verdict.lab));
  std::vector<Speed> speed;
  for (const protocol::Row& row : own) {
    if (row.kind != "speed") continue;
    Speed one;
    one.name = row.what;
    one.nanoseconds = row.value;
    if (const auto* unit = find(own, "speed unit", row.what)) one.addition = unit->value;
    if (const auto* other = find(reference, "speed", row.what)) {
      one.reference = other->value;
    } else if (const auto kept = ratios.find(row.what); kept != ratios.end()) {
      one.reference = kept->second * one.addition;
      one.is_estimate = true;
    }
    if (const auto* error = find(own, "speed error", row.what)) {
      one.error = error->value;
      one.points = error->n;
      one.integrand = error->on;
    }
    if (const auto* error = find(reference, "speed error", row.what)) {
      one.reference_error = error->value;
    }
    speed.push_back(std::move(one));
  }
  return speed;
}

}  // namespace mc::grader
