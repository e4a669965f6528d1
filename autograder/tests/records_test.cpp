// How test cases ended, from Catch2's listener through the pipe: points depend only on this.
#include <algorithm>
#include <csignal>
#include <stdexcept>
#include <string>

#include "checks/support/catch.hpp"
#include "checks/support/measure.hpp"
#include "judge/checkout/layout.hpp"
#include "judge/judging/check_process.hpp"
#include "tests/text.hpp"

namespace mc::tests::records {

// Not tests: a later test runs them and reads their records. They fail, so they are hidden.
TEST_CASE("1.1 requires", "[.report][points:3]") {
  const int n = 3;
  REQUIRE(n < 2);
}
TEST_CASE("1.2 checks, later", "[.report]") {
  CHECK(true);
  CHECK(std::string("a") == "b");
  CHECK(1 == 2);
}
TEST_CASE("1.3 fails", "[.report]") {
  FAIL("measured  1");
}
TEST_CASE("1.4 throws", "[.report]") {
  throw std::runtime_error("no value");
}
TEST_CASE("1.5 throws in an assertion", "[.report]") {
  const auto f = []() -> int { throw std::runtime_error("no value"); };
  REQUIRE(f() == 1);
}
TEST_CASE("1.6 checks nothing", "[.report]") {}
TEST_CASE("1.7 passes", "[.report]") {
  CHECK(true);
}
TEST_CASE("1.8 may fail", "[.report][!mayfail]") {
  CHECK(1 == 2);
}
TEST_CASE("1.9 crashes", "[.report]") {
  std::raise(SIGSEGV);
}

TEST_CASE("the record of a case says how it ended, for every kind of end in Catch2") {
  const auto program = grader::read_layout().build / "bin" / "grader_tests";
  const auto ends = grader::run_check_program(program, "[.report]", {}).ends();
  const auto end = [&](const std::string& task) {
    const auto found = std::find_if(ends.begin(), ends.end(),
                                    [&](auto& one) { return one.name.starts_with(task); });
    REQUIRE(found != ends.end());
    return *found;
  };
  CHECK(ends.size() == 9);
  CHECK(end("1.1").message == "REQUIRE( n < 2 ) was 3 < 2");
  CHECK(contains(end("1.1").tags, "[points:3]"));
  CHECK(contains(end("1.2").message, "\"a\" == \"b\""));
  CHECK(end("1.3").message == "measured  1");
  CHECK(end("1.4").message == "no value");
  CHECK(end("1.5").message == "REQUIRE( f() == 1 ) threw: no value");
  CHECK(end("1.6").message == "this check contains no expectation");
  for (const char* task : {"1.1", "1.2", "1.3", "1.4", "1.5", "1.6", "1.8", "1.9"}) {
    CAPTURE(task);
    CHECK_FALSE(end(task).passed);
    CHECK(end(task).crashed == std::string("1.4 1.5 1.9").find(task) < 11);
  }
  CHECK(end("1.7").passed);
}

TEST_CASE("1.0 records much", "[.much]") {
  const std::string much(std::size_t{1} << 20, 'x');
  for (int i = 0; i < 40; ++i) {
    checks::record(protocol::RecordKind::printed, much);
    checks::record(protocol::RecordKind::call, much);
  }
  CHECK(true);
}

TEST_CASE("however much a case records, its end is not cut off") {
  const auto program = grader::read_layout().build / "bin" / "grader_tests";
  const auto checked = grader::run_check_program(program, "[.much]", {});
  REQUIRE(checked.ends().size() == 1);
  CHECK(checked.ends()[0].passed);
  std::size_t printed = 0;
  for (const auto& one : checked.records) {
    if (one.kind == protocol::RecordKind::printed) printed += one.text.size();
  }
  CHECK(printed < (20u << 10));
}

TEST_CASE("a truncated record is ignored") {
  const protocol::CheckEnd end{"1.1 x", "[1.1]", true, false, "line\nline"};
  const std::string line = protocol::line_of({protocol::RecordKind::ended, protocol::text_of(end)});
  const auto ends_in = [](std::string_view lines) {
    return protocol::check_ends_in(protocol::records_in(lines));
  };
  REQUIRE(ends_in(line).size() == 1);
  CHECK(ends_in(line)[0].message == "line\nline");
  CHECK(ends_in(line)[0].passed);
  CHECK(ends_in("").empty());
  CHECK(ends_in("ended 1.1 x").empty());
  CHECK(ends_in("ended 1.1 x\\n[1.1]\\n1").empty());
}

}  // namespace mc::tests::records
