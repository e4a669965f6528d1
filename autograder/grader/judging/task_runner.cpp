#include "grader/judging/task_runner.hpp"

#include <algorithm>
#include <chrono>
#include <thread>

#include <fmt/format.h>

#include "grader/judging/catch_xml.hpp"
#include "protocol/environment.hpp"
#include "protocol/records.hpp"
#include "runner/text.hpp"
#include "sandbox/descriptor.hpp"
#include "sandbox/printable.hpp"

namespace mc::grader {
namespace {

/// What a process of checks may use for itself, beside the programs that it asks. A right answer is
/// judged in a second and 200 MB.
constexpr double check_cpu_seconds = 10;
constexpr std::size_t check_memory = std::size_t{1} << 30;
/// No verdict hangs on it: who comes this far was kept waiting by the machine.
constexpr double check_wall_seconds = 400;

/// Reads a pipe to its end in a thread of its own, so that its writer never waits.
class PipeReader {
 public:
  PipeReader() : ends_(sandbox::make_pipe()) {
    thread_ = std::thread([this] {
      // The arguments of a call as they are typed can take megabytes; a bound, and cut at it
      // exactly, so that a verdict does not depend on how the pipe was read.
      constexpr std::size_t most = std::size_t{32} << 20;
      std::string some;
      bool more = true;
      while (more) {
        more = sandbox::read_available(ends_.read, some, 0);
        text_.append(some, 0, most - text_.size());
        some.clear();
      }
    });
  }
  ~PipeReader() { finish(); }
  PipeReader(const PipeReader&) = delete;

  int write_end() const { return ends_.write.get(); }
  const std::string& finish() {
    ends_.write.reset();
    if (thread_.joinable()) thread_.join();
    return text_;
  }

 private:
  sandbox::Pipe ends_;
  std::string text_;
  std::thread thread_;
};

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

/// Why Catch2 has no word on a check.
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
      result->story = used_up ? Budget::why() : Budget::why_late();
      done();
      continue;
    }
    if (left <= 0) {
      result->status = Status::not_run;
      result->story = fmt::format("the {} s of CPU time of task {} were used up before this check",
                                  task_cpu_seconds, result->check.task);
      done();
      continue;
    }
    PipeReader records;
    sandbox::ProcessOptions process;
    process.environment = {
        {protocol::seed_variable, std::to_string(options.seed)},
        {protocol::program_variable, std::to_string(protocol::program_descriptor)},
        {protocol::records_variable, std::to_string(protocol::records_descriptor)}};
    process.descriptors = {{program.descriptor.get(), protocol::program_descriptor},
                           {records.write_end(), protocol::records_descriptor}};
    process.cpu_seconds = check_cpu_seconds;
    process.memory = layout.sanitized ? 0 : check_memory;
    process.wall_seconds = check_wall_seconds;
    const auto start = std::chrono::steady_clock::now();
    const sandbox::ProcessResult run =
        sandbox::run_process({layout.checks(lab.name).string(), result->check.name, "--reporter",
                              "xml", "--warn", "NoAssertions"},
                             process);
    result->seconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    left -= run.cpu_seconds;
    if (options.budget != nullptr) options.budget->use(run.cpu_seconds);

    bool todo = false;
    std::string machine;
    for (const protocol::Record& record : protocol::records_in(records.finish())) {
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
          result->dearest = record.text;
          break;
        case protocol::RecordKind::machine:
          machine = record.text;
          break;
      }
    }
    // A check's status comes from Catch2's own record of it and from nothing else.
    const auto xml = read_catch_xml(run.output);
    const auto record = std::find_if(xml.begin(), xml.end(),
                                     [&](auto& one) { return one.name == result->check.name; });
    if (run.out_of_time || !machine.empty()) {
      result->status = Status::not_judged;
      result->story = run.out_of_time
                          ? fmt::format("the machine is too busy: this check did not end in {} s",
                                        check_wall_seconds)
                          : sandbox::printable(machine);
    } else if (record == xml.end()) {
      result->status = Status::internal_error;
      result->story = without_record(run);
    } else if (record->crashed) {
      result->status = Status::internal_error;
      result->story = fmt::format("the autograder failed in this check: tell your instructor\n{}",
                                  sandbox::printable(record->message));
    } else if (record->success) {
      result->status = Status::passed;
    } else {
      result->status = todo ? Status::not_written : Status::failed;
      result->story = sandbox::printable(record->message);
    }
    done();
  }
}

}  // namespace mc::grader
