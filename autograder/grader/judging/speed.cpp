#include "grader/judging/speed.hpp"

#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <set>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "grader/judging/judge.hpp"
#include "protocol/environment.hpp"
#include "protocol/rows.hpp"

namespace mc::grader {
namespace fs = std::filesystem;
namespace {

/// Rows of the lab's [.speed] cases, of those `tasks`, by way of `file`.
std::vector<protocol::Row> measure(const Layout& layout, const Lab& lab,
                                   const sandbox::Program& program,
                                   const std::set<std::string>& tasks, const fs::path& file) {
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

/// In the same minute as the submission's own: what a machine does changes from one to the next.
std::vector<protocol::Row> rows_of_reference(const Layout& layout, const Lab& lab,
                                             const std::set<std::string>& tasks,
                                             const sandbox::Program& program,
                                             const std::vector<protocol::Row>& own) {
  if (!fs::exists(layout.solutions() / lab.file())) return {};
  const auto labs = find_labs(layout);
  const Submission solutions = open_submission(labs, layout.solutions());
  const Built built = build_program(layout, lab, solutions);
  if (!built.program) return {};
  if (built.program->path == program.path) return own;  // it is the reference itself
  return measure(layout, lab, *built.program, tasks,
                 layout.build / "speed" / fmt::format("{}.{}.reference.tsv", lab.name, getpid()));
}

const protocol::Row* find(const std::vector<protocol::Row>& rows, const std::string& kind,
                          const std::string& what) {
  for (const protocol::Row& row : rows) {
    if (row.kind == kind && row.what == what) return &row;
  }
  return nullptr;
}

}  // namespace

std::vector<Speed> measure_speed(const Layout& layout, const LabVerdict& verdict,
                                 const sandbox::Program& program) {
  std::set<std::string> passed;
  for (const CheckResult& result : verdict.checks) passed.insert(result.check.task);
  for (const CheckResult& result : verdict.checks) {
    if (result.status != Status::passed) passed.erase(result.check.task);
  }
  const auto own =
      measure(layout, verdict.lab, program, passed,
              layout.build / "speed" / fmt::format("{}.{}.tsv", verdict.lab.name, getpid()));
  if (own.empty()) return {};
  const auto reference = rows_of_reference(layout, verdict.lab, passed, program, own);
  std::vector<Speed> speed;
  for (const protocol::Row& row : own) {
    if (row.kind != "speed" && row.kind != "speed wrong") continue;
    Speed one;
    one.name = row.what;
    if (row.kind == "speed wrong") {
      one.wrong = row.on;
      speed.push_back(std::move(one));
      continue;
    }
    one.nanoseconds = row.value;
    if (const auto* other = find(reference, "speed", row.what)) one.reference = other->value;
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
