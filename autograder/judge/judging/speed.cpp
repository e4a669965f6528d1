#include "judge/judging/speed.hpp"

#include <unistd.h>

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "judge/judging/judge.hpp"
#include "protocol/environment.hpp"

namespace mc::grader {
namespace fs = std::filesystem;

std::vector<protocol::Row> speed_rows(const Layout& layout, const Lab& lab,
                                      const sandbox::Program& program,
                                      const std::set<std::string>& tasks) {
  const fs::path file = layout.build / "speed" / fmt::format("{}.{}.csv", lab.name, getpid());
  fs::create_directories(file.parent_path());
  fs::remove(file);
  run_hidden_cases(
      layout, lab, CaseKind::checks, program, "[.speed]",
      {.environment = {{protocol::rows_variable, file.string()},
                       {protocol::speed_tasks_variable, fmt::format("{}", fmt::join(tasks, " "))}},
       .wall_seconds = 60});
  const auto rows = protocol::rows_in(file);
  fs::remove(file);
  return rows;
}

std::vector<Speed> speed_in(const std::vector<protocol::Row>& rows) {
  std::vector<Speed> speed;
  for (const protocol::Comparison& one : protocol::comparisons_in(rows)) {
    speed.push_back({.name = one.task, .nanoseconds = one.ns});
    if (std::isnan(one.other)) continue;
    speed.back().plain = one.other;
    speed.back().noise = (one.high - one.low) / 2 / one.ratio;
  }
  for (const protocol::Row& row : rows) {
    const auto found = std::ranges::find(speed, row.task, &Speed::name);
    if (std::isnan(row.rmse) || found == speed.end()) continue;
    found->error = row.rmse;
    found->points = row.n;
    found->integrand = row.integrand;
  }
  return speed;
}

std::vector<Speed> measure_speed(const Layout& layout, const LabVerdict& verdict,
                                 const sandbox::Program& program) {
  std::set<std::string> passed;
  for (const CheckResult& result : verdict.checks) passed.insert(result.check.task);
  for (const CheckResult& result : verdict.checks) {
    if (result.status != Status::passed) passed.erase(result.check.task);
  }
  return speed_in(speed_rows(layout, verdict.lab, program, passed));
}

}  // namespace mc::grader
