#include "checks/measure.hpp"

#include <cstdlib>
#include <random>
#include <stdexcept>

#include <fmt/format.h>

#include "checks/catch.hpp"

namespace mc::checks {
namespace {

std::string environment(const char* name) {
  const char* value = std::getenv(name);
  return value == nullptr ? "" : value;
}

/// The program under judgement, as the grader hands it over: an open descriptor, or a path by hand.
const grader::Program& program() {
  static const grader::Program opened = [] {
    const std::string descriptor = environment("MC_PROGRAM_DESCRIPTOR");
    if (!descriptor.empty()) return grader::Program{std::stoi(descriptor), "the program"};
    const std::string path = environment("MC_PROGRAM");
    if (path.empty()) throw std::runtime_error("no program: MC_PROGRAM is not set");
    return grader::open_program(path);
  }();
  return opened;
}

std::uint64_t run_seed() {
  static const std::uint64_t seed = [] {
    const std::string text = environment("MC_SEED");
    return text.empty() ? std::random_device()() : std::stoull(text);
  }();
  return seed;
}

/// Escapes line ends, so that a record is one line.
std::string one_line(std::string_view text) {
  std::string line;
  for (const char c : text) {
    if (c == '\n') {
      line += "\\n";
    } else if (c == '\\') {
      line += "\\\\";
    } else {
      line += c;
    }
  }
  return line;
}

bool has_timed_out(std::string_view experiment) {
  const std::string all = ' ' + environment("MC_TIMED_OUT") + ' ';
  return all.find(fmt::format(" {} ", experiment)) != std::string::npos;
}

}  // namespace

void record(std::string_view kind, std::string_view text) {
  static std::FILE* const records = [] {
    const std::string descriptor = environment("MC_RECORDS_DESCRIPTOR");
    return descriptor.empty() ? nullptr : fdopen(std::stoi(descriptor), "w");
  }();
  if (records == nullptr) return;
  fmt::print(records, "{} {}\n", kind, one_line(text));
  std::fflush(records);
}

Rng check_rng() {
  std::uint64_t hash = mix_bits(run_seed() + 1);
  for (const char c : Catch::getResultCapture().getCurrentTestName()) {
    hash = mix_bits(hash ^ static_cast<unsigned char>(c));
  }
  return Rng(hash);
}

void fail(const std::string& story) {
  FAIL(story);
  std::abort();  // FAIL throws
}

void pass() {
  SUCCEED();
}

Call ask(std::string_view experiment, std::string call, std::string request,
         const grader::Limits& limits) {
  const grader::Program& judged = program();
  if (has_timed_out(experiment)) {
    fail(fmt::format("measured  nothing: {} ran out of time in a check before this one",
                     experiment));
  }
  Call made{std::move(call), grader::run_jailed(judged, request, limits)};
  if (!made.outcome.printed.empty()) record("printed", made.outcome.printed);
  if (made.outcome.timed_out) record("timed_out", experiment);
  return made;
}

void require_value(const Call& call) {
  const grader::Outcome& outcome = call.outcome;
  if (!outcome.answered) fail(fmt::format("measured  {} {}", call.text, outcome.failure));
  switch (outcome.status) {
    case wire::Status::value:
      return;
    case wire::Status::todo:
      record("todo", outcome.bytes);
      fail(fmt::format("not written yet: {}", outcome.bytes));
    case wire::Status::invalid_argument:
      fail(
          fmt::format("measured  {} threw std::invalid_argument: {}\n"
                      "expected  a value: these arguments are in order",
                      call.text, outcome.bytes));
    case wire::Status::out_of_range:
      fail(
          fmt::format("measured  {} threw std::out_of_range: {}\n"
                      "expected  a value: these arguments are in order",
                      call.text, outcome.bytes));
    case wire::Status::other_exception:
      fail(fmt::format("measured  {} threw {}\nexpected  a value", call.text, outcome.bytes));
  }
}

}  // namespace mc::checks
