#include "checks/support/measure.hpp"

#include <cstdlib>
#include <functional>
#include <random>
#include <stdexcept>
#include <system_error>

#ifdef __GLIBC__
#include <malloc.h>
#endif

#include <fmt/format.h>

#include "checks/support/catch.hpp"
#include "checks/support/validation.hpp"
#include "protocol/environment.hpp"
#include "sandbox/printable.hpp"

namespace mc::checks {

using protocol::RecordKind;

namespace {

#ifdef __GLIBC__
/// Keeps freed pages: requesting them again for large lists takes a fifth of a check's time.
[[maybe_unused]] const bool keeps_pages = [] {
  constexpr int megabyte = 1 << 20;
  return mallopt(M_MMAP_THRESHOLD, 32 * megabyte) != 0 &&
         mallopt(M_TRIM_THRESHOLD, 512 * megabyte) != 0;
}();
#endif

std::string environment(const char* name) {
  const char* value = std::getenv(name);
  return value == nullptr ? "" : value;
}

/// The program to judge: a descriptor opened by the grader, or a path when checks run by hand.
int program_descriptor() {
  static const sandbox::Program by_hand = [] {
    const std::string path = environment(protocol::program_path_variable);
    if (!environment(protocol::program_variable).empty()) return sandbox::Program{};
    if (path.empty()) throw std::runtime_error("no program: MC_PROGRAM is not set");
    return sandbox::open_program(path);
  }();
  static const std::string descriptor = environment(protocol::program_variable);
  return descriptor.empty() ? by_hand.descriptor.get() : std::stoi(descriptor);
}

std::uint64_t run_seed() {
  static const std::uint64_t seed = [] {
    const std::string text = environment(protocol::seed_variable);
    return text.empty() ? std::random_device()() : std::stoull(text);
  }();
  return seed;
}

/// The latest calls of this check, for the command that repeats one by hand.
struct PastCall {
  std::string text, experiment;
  std::function<std::string()> typed;  // called only if a check fails: a million numbers are long
};
std::vector<PastCall> past_calls;
constexpr std::size_t most_past_calls = 256;

/// The call that a failure report names, or the only one. Null if several calls look the same (long
/// lists are shortened), or if the failure is about many calls.
const PastCall* call_in(const std::string& report) {
  if (past_calls.size() == 1) return &past_calls.front();
  const PastCall* found = nullptr;
  std::size_t first = std::string::npos;
  for (const PastCall& call : past_calls) {
    const auto at = report.find(call.text);
    if (at == std::string::npos || at > first) continue;
    if (at == first && call.text.size() < found->text.size()) continue;
    first = at;
    found = &call;
  }
  if (found == nullptr) return nullptr;
  const std::string typed = found->typed();
  const bool is_ambiguous = std::ranges::any_of(past_calls, [&](auto& call) {
    return call.text == found->text && call.experiment == found->experiment &&
           call.typed() != typed;
  });
  return is_ambiguous ? nullptr : found;
}

/// The standard library's assertion that ended the program, if one did.
std::string assertion_in(const std::string& printed) {
  const auto at = printed.find("Assertion '");
  if (at == std::string::npos) return {};
  const auto start = at + std::string_view("Assertion '").size();
  // The program may have printed this itself: keep one line only.
  const std::string what = sandbox::printable_line(
      sandbox::shortened(printed.substr(start, printed.find('\'', start) - start), 200));
  const auto line = printed.rfind('\n', at) + 1;  // 0 if there is none
  const std::string_view where = std::string_view(printed).substr(line, at - line);
  for (const char* type : {"span", "vector", "array", "string", "optional"}) {
    if (where.find(fmt::format("::{}<", type)) != std::string_view::npos ||
        where.find(fmt::format("/{}:", type)) != std::string_view::npos) {
      return fmt::format("the standard library found {} broken in a std::{}", what, type);
    }
  }
  return fmt::format("the standard library found {} broken", what);
}

/// For a program that gave no answer: how it ended, and the usual causes.
[[noreturn]] void fail_without_answer(const Call& call) {
  const sandbox::Outcome& outcome = call.outcome;
  const std::string because = assertion_in(outcome.printed);
  Likely cause;
  if (outcome.end == sandbox::End::over_limit) {
    cause =
        "far more steps or memory than the header's cost allows, a loop that never ends for these "
        "arguments, or a negative size: as unsigned, -1 is 1.8e19"_likely;
  } else if (outcome.end == sandbox::End::crashed) {
    cause = because.empty()
                ? "an index out of range, an integer division by zero, or infinite recursion"_likely
                : "an index that is one too large, or an empty list where a value is needed"_likely;
  }
  fail(Failure{call.text + ' ' + outcome.failure, "an answer", because, cause});
}

}  // namespace

void (*on_missing)(std::string_view, const Call&) = nullptr;

Rng check_rng() {
  std::uint64_t hash = mix_bits(run_seed() + 1);
  for (const char c : Catch::getResultCapture().getCurrentTestName()) {
    hash = mix_bits(hash ^ static_cast<unsigned char>(c));
  }
  return Rng(hash);
}

Rng side_rng() {
  static std::uint64_t calls = 0;
  return Rng(check_rng()() ^ mix_bits(++calls));
}

sandbox::Outcome run_program(std::string_view request, const sandbox::Limits& limits) {
  const int program = program_descriptor();
  try {
    return sandbox::run_jailed(program, "the program", request, limits);
  } catch (const std::system_error& error) {
    record(protocol::RecordKind::machine, error.what());
    throw;
  }
}

void record_growth(double ratio, double limit, const std::string& what) {
  record(RecordKind::growth, fmt::format("{:.2f} {:.0f} {}", ratio, limit, what));
}

void fail(const std::string& report) {
  if (const PastCall* call = call_in(report)) {
    record(RecordKind::call, call->experiment + call->typed());
  }
  FAIL(without_empty_signs(report));
  std::abort();  // FAIL throws
}

void pass() {
  // Catch2 is slow, and some checks have a hundred thousand expectations: one per check is enough.
  static std::string counted;
  const std::string name = Catch::getResultCapture().getCurrentTestName();
  if (name == counted) return;
  SUCCEED();
  counted = name;
}

Call ask(std::string_view experiment, std::string call, Arguments arguments, std::string request,
         const sandbox::Limits& limits) {
  if (past_calls.size() == most_past_calls) past_calls.erase(past_calls.begin());
  past_calls.push_back({call, std::string(experiment), arguments.typed});
  Call made{std::move(call), run_program(request, limits)};
  keep_call(experiment, made, request, std::move(arguments));
  static double highest = 0.02;  // lower costs are not reported
  if (made.outcome.cpu_seconds > highest) {
    highest = made.outcome.cpu_seconds;
    record(RecordKind::cost, fmt::format("{:.3f} {}", highest, experiment));
  }
  if (!made.outcome.printed.empty()) record(RecordKind::printed, made.outcome.printed);
  return made;
}

void require_value(const Call& call) {
  const sandbox::Outcome& outcome = call.outcome;
  if (!outcome.answered) fail_without_answer(call);
  switch (outcome.status) {
    case wire::Status::value:
      return;
    case wire::Status::todo:
      record(RecordKind::todo, outcome.bytes);
      fail(fmt::format("not written yet: {}", outcome.bytes));
    case wire::Status::invalid_argument:
    case wire::Status::out_of_range:
      fail(Failure{
          fmt::format(
              "{} threw std::{}: {}", call.text,
              outcome.status == wire::Status::out_of_range ? "out_of_range" : "invalid_argument",
              outcome.bytes),
          "a value: these arguments are valid",
          "",
          {},
          "find the condition that refuses them: it may overflow, be rounded or be off by one"});
    case wire::Status::other_exception:
      fail(fmt::format("measured  {} threw {}\nexpected  a value", call.text, outcome.bytes));
  }
}

}  // namespace mc::checks
