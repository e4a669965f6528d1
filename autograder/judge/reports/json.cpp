#include <cstdint>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "judge/judging/repeat_commands.hpp"
#include "judge/reports/report.hpp"
#include "sandbox/printable.hpp"

namespace mc::grader {
namespace {

std::string output_of(const CheckResult& result, const LabVerdict& lab, std::uint64_t seed) {
  if (result.status == Status::passed) return "";
  // The reason is reported once, above all checks.
  if (!lab.no_program.empty()) return "not run: see the top";
  std::string text = describe(result, lab);
  if (result.status == Status::failed) {
    text += '\n' + failure_report(lab, result, own_repeat_command(lab.lab, result.check, seed));
  } else if (!result.report.empty() && result.status != Status::not_written) {
    text += '\n' + result.report;
  }
  if (!result.printed.empty())
    text += "\nit printed\n" + sandbox::marked(sandbox::shortened(result.printed, 2000));
  return text;
}

nlohmann::json as_json(const Speed& speed) {
  const auto number = [](const std::optional<double>& value) {
    return value ? nlohmann::json(*value) : nlohmann::json(nullptr);
  };
  return {{"name", speed.name},
          {"nanoseconds", speed.nanoseconds},
          {"plain", number(speed.plain)},
          {"error", number(speed.error)},
          {"points", speed.points}};
}

}  // namespace

std::string results_json(const Verdict& verdict) {
  auto tests = nlohmann::json::array(), speed = tests;
  std::string output = jail_warning(verdict);
  if (!verdict.found_in.empty()) output += fmt::format("found in {}\n", verdict.found_in);
  for (const LabVerdict& lab : verdict.labs) {
    output += fmt::format("{}: {:g} of {:g} points\n", lab.lab.title(), lab.earned(), lab.points());
    if (!lab.no_program.empty()) output += lab.no_program + "\n";
    output += report_speed(lab);
    for (const Speed& one : lab.speed) speed.push_back(as_json(one));
    for (const CheckResult& result : lab.checks) {
      if (result.check.is_stretch() && result.status == Status::not_written) continue;
      tests.push_back({{"name", result.check.name},
                       {"number", result.check.task},
                       {"score", result.earned()},
                       {"max_score", result.check.points},
                       {"status", result.status == Status::passed ? "passed" : "failed"},
                       {"output", output_of(result, lab, verdict.seed)},
                       {"output_format", "text"}});
    }
  }
  if (!verdict.unreadable.empty()) {
    output += "This submission cannot be read: " + verdict.unreadable + "\n";
  } else if (verdict.labs.empty())
    output += "This submission contains no lab files.\n";
  nlohmann::json all;
  all["score"] = verdict.earned();
  all["execution_time"] = verdict.seconds;
  all["output"] = output;
  all["output_format"] = "text";
  all["tests"] = std::move(tests);
  all["extra_data"] = {{"seed", verdict.seed},
                       {"version", verdict.version},
                       {"flags", verdict.flags},
                       {"jail_complete", verdict.jail_complete},
                       {"reads_confined", verdict.reads_confined},
                       {"speed", std::move(speed)}};
  return all.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + '\n';
}

}  // namespace mc::grader
