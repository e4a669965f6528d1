#include "grader/judge.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <mutex>
#include <thread>

#include <fmt/format.h>
#include <pugixml.hpp>

#include "grader/errors.hpp"
#include "grader/process.hpp"
#include "runner/text.hpp"

namespace mc::grader {
namespace {

using Clock = std::chrono::steady_clock;

constexpr int program_descriptor = 10;  // in the process of a check
constexpr int records_descriptor = 11;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

std::string trimmed(std::string text) {
  while (!text.empty() && std::isspace(static_cast<unsigned char>(text.back()))) text.pop_back();
  std::size_t first = 0;
  while (first < text.size() && (text[first] == '\n' || text[first] == ' ')) ++first;
  return text.substr(first);
}

/// Takes "[1.3][points:8][needs:1.1][needs:1.2]" apart.
Check parse_check(const XmlRecord& record) {
  Check check{record.name, record.name.substr(0, record.name.find(' ')), {}, 0, false};
  for (std::string_view tag : text::split(record.tags, '[')) {
    if (tag.ends_with(']')) tag.remove_suffix(1);
    if (tag.starts_with("points:")) check.points = std::strtod(tag.data() + 7, nullptr);
    if (tag == "slow") check.is_slow = true;
    if (tag.starts_with("needs:")) check.needs.emplace_back(tag.substr(6));
  }
  return check;
}

/// The records that a check writes (see checks/measure.hpp), and what they add to its result.
void read_records(const std::string& records, CheckResult& result,
                  std::vector<std::string>& timed_out) {
  for (const std::string_view line : text::split(records, '\n')) {
    const auto space = line.find(' ');
    if (space == std::string_view::npos) continue;
    const std::string_view kind = line.substr(0, space);
    std::string rest;
    for (std::size_t i = space + 1; i < line.size(); ++i) {
      if (line[i] == '\\' && i + 1 < line.size()) {
        rest += line[++i] == 'n' ? '\n' : line[i];
      } else {
        rest += line[i];
      }
    }
    if (kind == "printed") result.printed += rest;
    if (kind == "todo") result.status = Status::not_written;
    if (kind == "timed_out") timed_out.push_back(rest);
    if (kind == "p_value") {
      char* end = nullptr;
      PValue value;
      value.p = std::strtod(rest.c_str(), &end);
      value.alpha = std::strtod(end, &end);
      value.null = trimmed(end);
      result.p_values.push_back(value);
    }
  }
}

/// Reads a pipe to its end in a thread of its own, so that its writer never waits.
class PipeReader {
 public:
  PipeReader() : ends_(make_pipe()) {}
  int write_end() const { return ends_.second; }
  void start() {
    thread_ = std::thread([this] {
      char buffer[1 << 14];
      for (;;) {
        const ssize_t got = read(ends_.first, buffer, sizeof buffer);
        if (got <= 0) return;
        if (text_.size() < most) text_.append(buffer, static_cast<std::size_t>(got));
      }
    });
  }
  std::string finish() {
    close(ends_.second);
    thread_.join();
    close(ends_.first);
    return std::move(text_);
  }

 private:
  static constexpr std::size_t most = std::size_t{1} << 20;
  std::pair<int, int> ends_;
  std::string text_;
  std::thread thread_;
};

/// Judges the checks of one lab with a few workers.
class Panel {
 public:
  Panel(const Layout& layout, const Lab& lab, const Program& program, const JudgeOptions& options)
      : layout_(layout), lab_(lab), program_(program), options_(options), start_(Clock::now()) {}

  void run(std::vector<CheckResult>& results) {
    for (CheckResult& result : results) queue_.push_back(&result);
    std::stable_partition(queue_.begin(), queue_.end(),
                          [](const CheckResult* result) { return result->check.is_slow; });
    std::vector<std::thread> workers;
    for (unsigned i = 0; i < std::max(1u, options_.workers); ++i) {
      workers.emplace_back([&] {
        while (CheckResult* const result = take()) run_one(*result);
      });
    }
    for (auto& worker : workers) worker.join();
  }

 private:
  CheckResult* take() {
    const std::lock_guard lock(mutex_);
    return next_ < queue_.size() ? queue_[next_++] : nullptr;
  }

  void run_one(CheckResult& result) {
    const double left = options_.lab_seconds - seconds_since(start_);
    if (left <= 0) {
      result.status = Status::not_run;
      result.story =
          fmt::format("the lab's {} s were used up before this check", options_.lab_seconds);
      return;
    }
    std::string timed_out;
    {
      const std::lock_guard lock(mutex_);
      for (const std::string& experiment : timed_out_) timed_out += experiment + ' ';
    }
    PipeReader records;
    ProcessOptions process;
    process.environment = {{"MC_SEED", std::to_string(options_.seed)},
                           {"MC_TIMED_OUT", timed_out},
                           {"MC_PROGRAM_DESCRIPTOR", std::to_string(program_descriptor)},
                           {"MC_RECORDS_DESCRIPTOR", std::to_string(records_descriptor)}};
    process.descriptors = {{program_.descriptor, program_descriptor},
                           {records.write_end(), records_descriptor}};
    process.wall_seconds = left;
    records.start();
    const auto start = Clock::now();
    const ProcessResult run = run_process({layout_.checks(lab_.name).string(), result.check.name,
                                           "--reporter", "xml", "--warn", "NoAssertions"},
                                          process);
    result.seconds = seconds_since(start);
    const std::string told = records.finish();
    conclude(result, run, told);
  }

  /// A check's status comes from Catch2's own record of it and from nothing else.
  void conclude(CheckResult& result, const ProcessResult& run, const std::string& told) {
    std::vector<std::string> timed_out;
    result.status = Status::internal_error;
    read_records(told, result, timed_out);
    const auto xml = read_catch_xml(run.output);
    const auto record = std::find_if(xml.begin(), xml.end(),
                                     [&](auto& one) { return one.name == result.check.name; });
    if (run.out_of_time) {
      result.status = Status::not_run;
      result.story = fmt::format("the lab's {} s were used up in this check", options_.lab_seconds);
    } else if (record == xml.end()) {
      result.status = Status::internal_error;
      result.story = fmt::format(
          "the autograder has no record of this check (exit code {}, signal "
          "{}): tell your instructor\n{}",
          run.exit_code, run.signal, trimmed(printable(run.errors)));
    } else if (record->success) {
      result.status = Status::passed;
    } else {
      if (result.status != Status::not_written) result.status = Status::failed;
      result.story = trimmed(printable(record->message));
    }
    const std::lock_guard lock(mutex_);
    timed_out_.insert(timed_out_.end(), timed_out.begin(), timed_out.end());
  }

  const Layout& layout_;
  const Lab& lab_;
  const Program& program_;
  const JudgeOptions& options_;
  const Clock::time_point start_;
  std::mutex mutex_;
  std::vector<CheckResult*> queue_;
  std::size_t next_ = 0;
  std::vector<std::string> timed_out_;
};

/// A check that failed while a task it needs has failed too is waiting: one fault, shown once.
void find_waiting(std::vector<CheckResult>& results) {
  const auto stands = [&](const std::string& task) {
    return std::all_of(results.begin(), results.end(), [&](auto& other) {
      return other.check.task != task || other.status == Status::passed;
    });
  };
  for (CheckResult& result : results) {
    const auto& needs = result.check.needs;
    if (result.status == Status::failed && !std::all_of(needs.begin(), needs.end(), stands)) {
      result.status = Status::waiting;
    }
  }
}

std::string repeat_command(const Lab& lab, const Check& check, const JudgeOptions& options) {
  const bool plain = options.submission.empty() || options.submission == "starter";
  const bool quoted = options.submission.find_first_of(" '\"$&;()<>|*?") != std::string::npos;
  return fmt::format("./lab check {}{} --only {} --seed {}", lab.name,
                     plain    ? ""
                     : quoted ? fmt::format(" \"{}\"", options.submission)
                              : " " + options.submission,
                     check.task, options.seed);
}

}  // namespace

std::vector<XmlRecord> read_catch_xml(std::string_view xml) {
  pugi::xml_document document;
  std::vector<XmlRecord> records;
  if (!document.load_buffer(xml.data(), xml.size())) return records;  // cut short: no record at all
  for (const auto& found : document.select_nodes("//TestCase")) {
    const pugi::xml_node node = found.node();
    const pugi::xml_node overall = node.child("OverallResult");
    XmlRecord record{node.attribute("name").value(), node.attribute("tags").value(), false, {}};
    record.success = overall.attribute("success").as_bool();
    for (const char* kind : {"Failure", "Exception", "FatalErrorCondition"}) {
      const auto failure = node.select_node(fmt::format(".//{}", kind).c_str()).node();
      if (failure && record.message.empty()) record.message = failure.text().get();
    }
    // Catch2 calls [!mayfail] and [!shouldfail] a success; here a failure is a failure.
    if (!record.message.empty()) record.success = false;
    if (!record.success && record.message.empty()) record.message = "this check checked nothing";
    records.push_back(std::move(record));
  }
  return records;
}

ProcessResult run_hidden_cases(const Layout& layout, const Lab& lab, const Program& program,
                               const std::string& tag, ProcessOptions options) {
  options.environment.insert(
      options.environment.end(),
      {{"MC_PROGRAM_DESCRIPTOR", std::to_string(program_descriptor)}, {"MC_SEED", "1"}});
  options.descriptors = {{program.descriptor, program_descriptor}};
  return run_process({layout.checks(lab.name).string(), tag, "--reporter", "xml"}, options);
}

std::vector<Check> expected_checks(const Layout& layout, const Lab& lab) {
  const ProcessResult run =
      run_process({layout.checks(lab.name).string(), "--reporter", "xml"},
                  {.environment = {{"MC_PROGRAM_DESCRIPTOR", ""}, {"MC_PROGRAM", ""}}});
  std::vector<Check> checks;
  for (const XmlRecord& record : read_catch_xml(run.output)) checks.push_back(parse_check(record));
  if (checks.empty()) {
    throw MachineError(
        fmt::format("the checks of lab {} are not built: run ./lab setup", lab.name));
  }
  std::stable_sort(checks.begin(), checks.end(), [](const Check& a, const Check& b) {
    return std::strtod(a.task.c_str(), nullptr) < std::strtod(b.task.c_str(), nullptr);
  });
  return checks;
}

void wait_for_labs(LabVerdict& verdict,
                   const std::function<bool(const std::string& lab)>& is_finished) {
  for (CheckResult& result : verdict.checks) {
    if (result.status != Status::failed) continue;
    for (const std::string& need : result.check.needs) {
      const bool is_lab = need.find('.') == std::string::npos;
      if (!is_lab || is_finished(need)) continue;
      result.status = Status::waiting;
      verdict.unfinished.push_back(need);
      break;
    }
  }
}

LabVerdict judge_lab(const Layout& layout, const Lab& lab, const Built& built,
                     const JudgeOptions& options) {
  const auto start = Clock::now();
  LabVerdict verdict{lab, {}, built.failure, {}, 0};
  for (const Check& check : expected_checks(layout, lab)) {
    if (!options.only.empty() && check.task != options.only) continue;
    if (options.skip_slow && check.is_slow) continue;
    CheckResult result;
    result.check = check;
    result.repeat = repeat_command(lab, check, options);
    verdict.checks.push_back(std::move(result));
  }
  if (verdict.checks.empty()) {
    throw UsageError(fmt::format("lab {} has no task {}", lab.name, options.only));
  }
  if (built.program) {
    Panel(layout, lab, *built.program, options).run(verdict.checks);
    find_waiting(verdict.checks);
  } else {
    for (CheckResult& result : verdict.checks) {
      result.status = Status::not_run;
      result.story = built.failure;
    }
  }
  verdict.seconds = seconds_since(start);
  return verdict;
}

}  // namespace mc::grader
