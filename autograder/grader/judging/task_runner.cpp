#include "grader/judging/task_runner.hpp"

#include <algorithm>
#include <chrono>
#include <functional>
#include <string>

#include <fmt/format.h>

#include "grader/judging/check_process.hpp"
#include "protocol/environment.hpp"
#include "protocol/records.hpp"
#include "runner/text.hpp"
#include "sandbox/printable.hpp"

namespace mc::grader {
namespace {

/// What a process of checks may use for itself, apart from the programs that it runs. A right
/// answer is judged in 1 s of CPU time and 200 MB.
constexpr double check_cpu_seconds = 10;
constexpr std::size_t check_memory = std::size_t{1} << 30;
/// No verdict hangs on it: who comes this far was kept waiting by the machine.
constexpr double check_wall_seconds = 400;

/// What is kept of what a program prints, for all checks of a task.
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

/// Why there is no record of a check's end.
std::string without_record(const sandbox::ProcessResult& run) {
  return fmt::format(
      "the autograder has no record of this check (exit code {}, signal {}): tell your "
      "instructor\n{}",
      run.exit_code, run.signal, sandbox::printable(run.errors));
}

}  // namespace

void run_task(const Layout& layout, const Lab& lab, const sandbox::Program& program,
              const JudgeOptions& options, const std::vector<CheckResult*>& checks,
              const std::function<void()>& done) {
  double left = task_cpu_seconds;
  std::size_t printed_left = most_printed;
  for (CheckResult* const result : checks) {
    if (options.budget != nullptr && (options.budget->is_used_up() || options.budget->is_late())) {
      const bool used_up = options.budget->is_used_up();
      result->status = used_up ? Status::not_run : Status::not_judged;
      result->report = used_up ? Budget::why() : Budget::why_late();
      done();
      continue;
    }
    if (left <= 0) {
      result->status = Status::not_run;
      result->report = fmt::format("task {} used up its {} s of CPU time before this check",
                                   result->check.task, task_cpu_seconds);
      done();
      continue;
    }
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
        run_check_program(layout.checks(lab.name), result->check.name, process);
    const sandbox::ProcessResult& run = checked.result;
    result->seconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    left -= run.cpu_seconds;
    if (options.budget != nullptr) options.budget->use(run.cpu_seconds);

    bool todo = false;
    std::string machine;
    for (const protocol::Record& record : checked.records) {
      switch (record.kind) {
        case protocol::RecordKind::printed:
          keep_printed(*result, record.text, printed_left);
          break;
        case protocol::RecordKind::todo:
          todo = true;
          break;
        case protocol::RecordKind::p_value:
          result->p_values.push_back(protocol::p_value_in(record.text));
          break;
        case protocol::RecordKind::call:
          for (const auto line : text::split(record.text, '\n')) result->call.emplace_back(line);
          break;
        case protocol::RecordKind::cost:
          result->costliest = record.text;
          break;
        case protocol::RecordKind::machine:
          machine = record.text;
          break;
        case protocol::RecordKind::ended:
          break;
      }
    }
    // A check's status comes from the record of its end and from nothing else.
    const auto ends = checked.ends();
    const auto end = std::find_if(ends.begin(), ends.end(),
                                  [&](auto& one) { return one.name == result->check.name; });
    if (run.out_of_time || !machine.empty()) {
      result->status = Status::not_judged;
      result->report =
          run.out_of_time
              ? fmt::format("the machine is too busy: this check did not finish in {} s",
                            check_wall_seconds)
              : sandbox::printable(machine);
    } else if (end == ends.end()) {
      result->status = Status::internal_error;
      result->report = without_record(run);
    } else if (end->crashed) {
      result->status = Status::internal_error;
      result->report =
          fmt::format("the autograder failed during this check: tell your instructor\n{}",
                      sandbox::printable(end->message));
    } else if (end->passed) {
      result->status = Status::passed;
    } else {
      result->status = todo ? Status::not_written : Status::failed;
      result->report = sandbox::printable(end->message);
    }
    done();
  }
}

}  // namespace mc::grader
