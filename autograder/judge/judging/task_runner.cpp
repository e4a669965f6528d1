#include "judge/judging/task_runner.hpp"

#include <algorithm>
#include <chrono>
#include <functional>
#include <string>

#include <fmt/format.h>

#include "judge/judging/check_process.hpp"
#include "protocol/environment.hpp"
#include "protocol/records.hpp"
#include "runner/text.hpp"
#include "sandbox/printable.hpp"

namespace mc::grader {
namespace {

/// The limits of a check's own process, without the programs that it runs. For a correct answer it
/// takes 1 s of CPU time and 200 MB.
constexpr double check_cpu_seconds = 30;
constexpr std::size_t check_memory = std::size_t{1} << 30;
/// Does not affect verdicts: a check that reaches it was delayed by the machine.
constexpr double check_wall_seconds = 400;

/// How much of the printed text is kept, for all checks of a task together.
constexpr std::size_t most_printed = std::size_t{16} << 10;

void keep_printed(CheckResult& result, const std::string& text, std::size_t& left) {
  if (text.size() <= left) {
    result.printed += text;
    left -= text.size();
  } else {
    result.printed += sandbox::shortened(text, left);
    left = 0;
  }
}

/// What the records of a check say about it, apart from its end.
struct Findings {
  bool todo = false;            ///< the task is not written yet
  std::string machine_failure;  ///< how the machine failed; empty if it did not
};

/// Copies records into the result.
Findings read_records(const std::vector<protocol::Record>& records, std::size_t& printed_left,
                      CheckResult& result) {
  Findings found;
  for (const protocol::Record& record : records) {
    switch (record.kind) {
      case protocol::RecordKind::printed:
        keep_printed(result, record.text, printed_left);
        break;
      case protocol::RecordKind::todo:
        found.todo = true;
        break;
      case protocol::RecordKind::p_value:
        result.p_values.push_back(protocol::p_value_in(record.text));
        break;
      case protocol::RecordKind::call:
        for (const auto line : text::split(record.text, '\n')) result.call.emplace_back(line);
        break;
      case protocol::RecordKind::cost:
        result.costliest = record.text;
        break;
      case protocol::RecordKind::growth:
        result.growths.push_back(record.text);
        break;
      case protocol::RecordKind::machine:
        found.machine_failure = record.text;
        break;
      case protocol::RecordKind::ended:
        break;
    }
  }
  return found;
}

/// Runs the check and fills in its result; returns the CPU time in seconds.
double run_check(const Layout& layout, const Lab& lab, const sandbox::Program& program,
                 const JudgeOptions& options, std::size_t& printed_left, CheckResult& result) {
  sandbox::ProcessOptions process;
  process.environment = {
      {protocol::seed_variable, std::to_string(options.seed)},
      {protocol::program_variable, std::to_string(protocol::program_descriptor)}};
  process.descriptors = {{program.descriptor.get(), protocol::program_descriptor}};
  process.cpu_seconds = check_cpu_seconds;
  process.memory = layout.sanitized ? 0 : check_memory;
  process.wall_seconds = check_wall_seconds;
  const auto start = std::chrono::steady_clock::now();
  const CheckProcess checked =
      run_check_program(layout.checks(lab.name), result.check.name, process);
  const sandbox::ProcessResult& run = checked.result;
  result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();

  const Findings found = read_records(checked.records, printed_left, result);
  // A check's status comes from the record of its end and from nothing else.
  const auto ends = checked.ends();
  const auto end =
      std::ranges::find_if(ends, [&](auto& one) { return one.name == result.check.name; });
  const auto set = [&](Status status, const std::string& report) {
    result.status = status;
    result.report = sandbox::printable(report);
  };
  if (run.out_of_time) {
    set(Status::not_judged,
        fmt::format("the machine is too busy: this check did not finish in {} s",
                    check_wall_seconds));
  } else if (!found.machine_failure.empty()) {
    set(Status::not_judged, found.machine_failure);
  } else if (end == ends.end()) {
    set(Status::internal_error,
        fmt::format("the autograder has no record of this check (exit code {}, signal {}): tell "
                    "your instructor\n{}",
                    run.exit_code, run.signal, run.errors));
  } else if (end->crashed) {
    set(Status::internal_error,
        "the autograder failed during this check: tell your instructor\n" + end->message);
  } else if (end->passed) {
    result.status = Status::passed;
  } else {
    set(found.todo ? Status::not_written : Status::failed, end->message);
  }
  return run.cpu_seconds;
}

}  // namespace

void run_task(const Layout& layout, const Lab& lab, const sandbox::Program& program,
              const JudgeOptions& options, const std::vector<CheckResult*>& checks,
              const std::function<void()>& done) {
  double left = task_cpu_seconds;
  std::size_t printed_left = most_printed;
  Budget* const budget = options.budget;
  for (CheckResult* const result : checks) {
    if (budget != nullptr && budget->is_used_up()) {
      result->status = Status::not_run;
      result->report = Budget::why();
    } else if (budget != nullptr && budget->is_late()) {
      result->status = Status::not_judged;
      result->report = Budget::why_late();
    } else if (left <= 0) {
      result->status = Status::not_run;
      result->report = fmt::format("task {} used up its {} s of CPU time before this check",
                                   result->check.task, task_cpu_seconds);
    } else {
      const double used = run_check(layout, lab, program, options, printed_left, *result);
      left -= used;
      if (budget != nullptr) budget->use(used);
    }
    done();
  }
}

}  // namespace mc::grader
