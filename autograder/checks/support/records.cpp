// The records that a process of checks sends to the grader, among them how each test case ended.

#include <cstdio>
#include <cstdlib>
#include <string>

#include <fmt/format.h>

#include "checks/support/measure.hpp"
#include "protocol/environment.hpp"
#include "sandbox/printable.hpp"

#if __has_include(<catch2/catch_test_macros.hpp>)
#include <catch2/catch_test_case_info.hpp>
#include <catch2/reporters/catch_reporter_event_listener.hpp>
#include <catch2/reporters/catch_reporter_registrars.hpp>
#else
#include <catch2/catch.hpp>
#endif

namespace mc::checks {
namespace {

/// How many bytes a case may record: of printed text as much as a verdict keeps, and of all but its
/// end less than the grader reads, so that the end is never cut off.
constexpr std::size_t most_printed = std::size_t{16} << 10, most_of_case = std::size_t{24} << 20;
std::size_t printed = 0, recorded = 0;

}  // namespace

void record(protocol::RecordKind kind, const std::string& whole) {
  std::string text = whole;
  if (kind == protocol::RecordKind::printed) {
    if (printed >= most_printed) return;
    text = sandbox::shortened(whole, most_printed - printed);
    printed += text.size();
  }
  const std::string line = protocol::line_of({kind, text});
  if (kind != protocol::RecordKind::ended) {
    if (line.size() > most_of_case - recorded) return;
    recorded += line.size();
  }
  static std::FILE* const records = [] {
    const char* const descriptor = std::getenv(protocol::records_variable);
    return descriptor == nullptr || *descriptor == '\0' ? nullptr
                                                        : fdopen(std::stoi(descriptor), "w");
  }();
  if (records == nullptr) return;
  fmt::print(records, "{}\n", line);
  std::fflush(records);
}

namespace {

// The two versions of Catch2 differ in the listener's base and in what assertionEnded() returns.
#if __has_include(<catch2/catch_test_macros.hpp>)
using ListenerBase = Catch::EventListenerBase;
using AssertionResult = void;
#else
using ListenerBase = Catch::TestEventListenerBase;
using AssertionResult = bool;
#endif

std::string trimmed(const std::string& text) {
  const auto first = text.find_first_not_of(" \t\r\n");
  if (first == std::string::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t\r\n") - first + 1);
}

/// The text of a FAIL; the expression and values of a REQUIRE or CHECK.
std::string message_of(const Catch::AssertionResult& result) {
  const std::string message = trimmed(std::string(result.getMessage()));
  if (!result.hasExpression()) return message.empty() ? "failed" : message;
  const std::string asked = std::string(result.getExpressionInMacro());
  if (result.getResultType() == Catch::ResultWas::ThrewException) {
    return fmt::format("{} threw: {}", asked, message);
  }
  return fmt::format("{} was {}", asked, result.getExpandedExpression());
}

class RecordListener : public ListenerBase {
 public:
  using ListenerBase::ListenerBase;

  void testCaseStarting(const Catch::TestCaseInfo& info) override {
    end_ = {info.name, info.tagsAsString(), false, false, {}};
    printed = recorded = 0;
    has_failed_ = false;
  }
  AssertionResult assertionEnded(const Catch::AssertionStats& stats) override {
    const Catch::AssertionResult& result = stats.assertionResult;
    // Catch2 calls a failure of [!mayfail] a success; here a failure is a failure.
    if (!result.succeeded() && !has_failed_) {
      has_failed_ = true;
      end_.message = message_of(result);
      end_.crashed = result.getResultType() == Catch::ResultWas::ThrewException ||
                     result.getResultType() == Catch::ResultWas::FatalErrorCondition;
    }
    return AssertionResult();
  }
  void testCaseEnded(const Catch::TestCaseStats& stats) override {
    const bool has_asserted = stats.totals.assertions.total() > 0;
    end_.passed = has_asserted && !has_failed_ && stats.totals.assertions.failed == 0;
    if (!end_.passed && end_.message.empty()) end_.message = "this check contains no expectation";
    record(protocol::RecordKind::ended, protocol::text_of(end_));
  }

 private:
  protocol::CheckEnd end_;
  bool has_failed_ = false;
};

CATCH_REGISTER_LISTENER(RecordListener)

}  // namespace
}  // namespace mc::checks
