#include "judge/judging/judge.hpp"

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <map>
#include <mutex>
#include <set>

#include <fmt/format.h>

#include "judge/base/errors.hpp"
#include "judge/base/side_by_side.hpp"
#include "judge/judging/check_process.hpp"
#include "judge/judging/points.hpp"
#include "judge/judging/repeat_commands.hpp"
#include "judge/judging/task_runner.hpp"
#include "protocol/environment.hpp"
#include "runner/text.hpp"

namespace mc::grader {
namespace {

/// Parses "[1.3][points:8][needs:1.1][needs:1.2]".
Check parse_check(const protocol::CheckEnd& record) {
  Check check;
  check.name = record.name;
  check.task = record.name.substr(0, record.name.find(' '));
  for (std::string_view tag : text::split(record.tags, '[')) {
    if (tag.ends_with(']')) tag.remove_suffix(1);
    if (tag.starts_with("points:")) check.points = std::strtod(tag.data() + 7, nullptr);
    if (tag == "main") check.is_main = true;
    if (tag == "edge") check.is_edge = true;
    if (tag.starts_with("needs:")) check.needs.emplace_back(tag.substr(6));
  }
  return check;
}

/// Checks by task; those of a task follow each other.
std::vector<std::vector<CheckResult*>> by_task(std::vector<CheckResult>& results) {
  std::vector<std::vector<CheckResult*>> tasks;
  for (CheckResult& result : results) {
    const bool is_new = tasks.empty() || tasks.back()[0]->check.task != result.check.task;
    (is_new ? tasks.emplace_back() : tasks.back()).push_back(&result);
  }
  return tasks;
}

/// Judges tasks side by side; with `first`, in order until one is not right: later ones are not
/// reported. Stretch checks do not count.
void run_checks(const Layout& layout, const Lab& lab, const sandbox::Program& program,
                const JudgeOptions& options, std::vector<CheckResult>& results) {
  const auto tasks = by_task(results);
  std::mutex mutex;
  std::size_t done = 0;
  const auto run = [&](std::size_t i) {
    run_task(layout, lab, program, options, tasks[i], [&] {
      const std::lock_guard lock(mutex);
      ++done;
      if (options.progress) options.progress(done, results.size());
    });
  };
  if (!options.first) return run_side_by_side(tasks.size(), std::max(1u, options.workers), run);
  for (std::size_t i = 0; i < tasks.size(); ++i) {
    run(i);
    const bool is_right = std::ranges::all_of(tasks[i], [](auto* result) {
      return result->status == Status::passed || result->check.is_stretch();
    });
    if (!is_right) break;
  }
  results.resize(done);
}

/// A check that fails after a task it needs has failed is waiting: one fault is shown once. A
/// task's misuse and edge cases do not hold up other tasks. A check that needs its own task waits
/// for the checks of this task above it.
void find_waiting(std::vector<CheckResult>& results) {
  const auto passed_basics = [&](const std::string& task) {
    return std::ranges::all_of(results, [&](auto& other) {
      return other.check.task != task || other.check.is_edge || other.status == Status::passed;
    });
  };
  std::set<std::string> failed_above;
  for (CheckResult& result : results) {
    if (result.status != Status::failed) continue;
    const auto is_met = [&](const std::string& need) {
      return need == result.check.task ? !failed_above.contains(need) : passed_basics(need);
    };
    if (!std::ranges::all_of(result.check.needs, is_met)) result.status = Status::waiting;
    failed_above.insert(result.check.task);
  }
}

/// An answer that ignores the task earns nothing for what it happens to do right: a task's checks
/// count only if its main check passes.
void withhold(std::vector<CheckResult>& results) {
  std::set<std::string> undone;
  for (const CheckResult& result : results) {
    if (result.check.is_main && result.status != Status::passed) undone.insert(result.check.task);
  }
  for (CheckResult& result : results) {
    const bool counts = !undone.contains(result.check.task);
    if (result.status == Status::passed && !counts) result.status = Status::withheld;
  }
}

std::filesystem::path program_with(CaseKind kind, const Layout& layout, const Lab& lab) {
  return kind == CaseKind::checks ? layout.checks(lab.name) : layout.measurements(lab.name);
}

}  // namespace

std::vector<Check> expected_checks(const Layout& layout, const Lab& lab) {
  static std::mutex mutex;
  static std::map<std::string, std::vector<Check>> known;  // one run per lab and process
  const std::lock_guard lock(mutex);
  if (const auto found = known.find(lab.name); found != known.end()) return found->second;
  std::vector<Check> checks;
  const CheckProcess run = run_check_program(
      layout.checks(lab.name), "",
      {.environment = {{protocol::program_variable, ""}, {protocol::program_path_variable, ""}}});
  for (const protocol::CheckEnd& one : run.ends()) checks.push_back(parse_check(one));
  if (checks.empty()) {
    throw MachineError(
        fmt::format("the checks of lab {} are not built: run ./lab setup", lab.name));
  }
  apply_points(layout.root, lab, checks);
  std::ranges::stable_sort(checks, [](const Check& a, const Check& b) {
    return task_number(a.task) < task_number(b.task);
  });
  return known[lab.name] = checks;
}

void wait_for_labs(LabVerdict& verdict,
                   const std::function<bool(const std::string& need)>& is_finished) {
  for (CheckResult& result : verdict.checks) {
    if (result.status != Status::failed) continue;
    for (const std::string& need : result.check.needs) {
      const bool is_own = std::atoi(need.c_str()) == verdict.lab.number;
      if (is_own || is_finished(need)) continue;
      result.status = Status::waiting;
      auto& unfinished = verdict.unfinished;
      if (std::ranges::find(unfinished, need) == unfinished.end()) {
        unfinished.push_back(need);
      }
      break;
    }
  }
}

LabVerdict judge_lab(const Layout& layout, const Lab& lab, const BuildResult& built,
                     const JudgeOptions& options) {
  const auto start = std::chrono::steady_clock::now();
  LabVerdict verdict{lab, {}, built.failure, {}, 0, {}};
  for (const Check& check : expected_checks(layout, lab)) {
    if (!options.only.empty() && check.task != options.only) continue;
    if (!options.checks.empty() && !options.checks.contains(check.name)) continue;
    CheckResult result;
    result.check = check;
    result.repeat = repeat_command(lab, check, options);
    verdict.checks.push_back(std::move(result));
  }
  if (verdict.checks.empty()) {
    throw UsageError(fmt::format("lab {} has no task {}", lab.name, options.only));
  }
  if (built.program) {
    run_checks(layout, lab, *built.program, options, verdict.checks);
    find_waiting(verdict.checks);
    withhold(verdict.checks);
    for (CheckResult& result : verdict.checks) {
      if (result.status != Status::failed || result.call.empty() || !options.submission.empty() ||
          options.with_reference) {
        continue;  // ./lab run has no sandbox: it is for your own code only
      }
      result.by_hand = by_hand_command(layout, lab, result.call, options);
    }
  } else {
    for (CheckResult& result : verdict.checks) {
      result.status = Status::not_run;
      result.report = built.failure;
    }
  }
  verdict.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return verdict;
}

std::vector<std::string> hidden_cases(const Layout& layout, const Lab& lab, CaseKind kind,
                                      const std::string& tag) {
  // Without a program and an output file, each of them ends at once.
  const CheckProcess run =
      run_check_program(program_with(kind, layout, lab), tag,
                        {.environment = {{protocol::program_variable, ""},
                                         {protocol::program_path_variable, ""},
                                         {protocol::plot_data_variable, "/nowhere"},
                                         {protocol::rows_variable, "/nowhere/rows"}}});
  std::vector<std::string> names;
  for (const protocol::CheckEnd& one : run.ends()) names.push_back(one.name);
  return names;
}

CheckProcess run_hidden_cases(const Layout& layout, const Lab& lab, CaseKind kind,
                              const sandbox::Program& program, const std::string& which,
                              sandbox::ProcessOptions options) {
  options.environment.insert(
      options.environment.end(),
      {{protocol::program_variable, std::to_string(protocol::program_descriptor)},
       {protocol::seed_variable, "1"}});
  options.descriptors = {{program.descriptor.get(), protocol::program_descriptor}};
  return run_check_program(program_with(kind, layout, lab), which, std::move(options));
}

}  // namespace mc::grader
