// read_catch_xml on reports as Catch2 writes them: points depend on nothing else.
#include <algorithm>
#include <stdexcept>
#include <string>

#include "checks/support/catch.hpp"
#include "grader/context/layout.hpp"
#include "grader/judging/catch_xml.hpp"
#include "sandbox/process.hpp"

namespace mc::tests::xml {

using grader::read_catch_xml;

namespace {

const std::string cases = R"(
    <TestCase name="1.1 fails" tags="[1.1][needs:1.0][points:3]" filename="s.cpp" line="2">
      <Failure filename="s.cpp" line="2">
        measured  1 &lt; 2 &amp; "x"
expected  3
      </Failure>
      <OverallResult success="false"/>
    </TestCase>
    <TestCase name="1.2 passes" tags="[1.2]" filename="s.cpp" line="3">
      <OverallResult success="true"/>
    </TestCase>
    <TestCase name="1.3 may fail" tags="[!mayfail][1.3]" filename="s.cpp" line="4">
      <Failure filename="s.cpp" line="4">
        bad
      </Failure>
      <OverallResult success="true"/>
    </TestCase>
    <TestCase name="1.4 checks nothing" tags="[1.4]" filename="s.cpp" line="5">
      <OverallResult success="false"/>
    </TestCase>
    <TestCase name="1.5 crashes" tags="[1.5]" filename="s.cpp" line="9">
      <Section name="a" filename="s.cpp" line="8">
        <FatalErrorCondition filename="s.cpp" line="9">
          SIGSEGV - Segmentation violation signal
        </FatalErrorCondition>
      </Section>
      <OverallResult success="false"/>
    </TestCase>
    <TestCase name="1.6 requires" tags="[1.6]" filename="s.cpp" line="12">
      <Expression success="true" type="CHECK" filename="s.cpp" line="13">
        <Original>
          true
        </Original>
        <Expanded>
          true
        </Expanded>
      </Expression>
      <Expression success="false" type="REQUIRE" filename="s.cpp" line="14">
        <Original>
          n &lt; most
        </Original>
        <Expanded>
          3 &lt; 2
        </Expanded>
      </Expression>
      <OverallResult success="false"/>
    </TestCase>
    <TestCase name="1.7 throws where it asks" tags="[1.7]" filename="s.cpp" line="20">
      <Expression success="false" type="REQUIRE" filename="s.cpp" line="21">
        <Original>
          f() == 1
        </Original>
        <Expanded>
          f() == 1
        </Expanded>
        <Exception filename="s.cpp" line="21">
          no value
        </Exception>
      </Expression>
      <OverallResult success="false"/>
    </TestCase>
)";
const std::string head = R"(<?xml version="1.0" encoding="UTF-8"?>)";
const std::string version_2 =
    head + R"(<Catch name="s"><Group name="s">)" + cases +
    R"(<OverallResults successes="1" failures="3" expectedFailures="1"/></Group></Catch>)";
const std::string version_3 =
    head + R"(<Catch2TestRun name="s" rng-seed="7" catch2-version="3.4.0" filters="x">)" + cases +
    R"(<OverallResults successes="1" failures="3" expectedFailures="1" skips="0"/></Catch2TestRun>)";

}  // namespace

TEST_CASE("both versions of Catch2's report") {
  for (const std::string& report : {version_2, version_3}) {
    const auto records = read_catch_xml(report);
    REQUIRE(records.size() == 7);
    CHECK(records[0].name == "1.1 fails");
    CHECK(records[0].tags == "[1.1][needs:1.0][points:3]");
    CHECK_FALSE(records[0].success);
    CHECK(records[0].message.find("measured  1 < 2 & \"x\"\nexpected  3") != std::string::npos);
    CHECK(records[1].success);
    CHECK(records[1].message.empty());
    CHECK_FALSE(records[3].success);
    CHECK(records[3].message == "this check checked nothing");
    CHECK_FALSE(records[4].success);
    CHECK(records[4].message.find("SIGSEGV") != std::string::npos);
    CHECK_FALSE(records[5].success);
    CHECK(records[5].message == "REQUIRE(n < most) was 3 < 2");
    CHECK_FALSE(records[6].success);
    CHECK(records[6].message == "REQUIRE(f() == 1) threw: no value");
  }
}

TEST_CASE("a failure is a failure, whatever Catch2 calls it") {
  const auto records = read_catch_xml(version_2);
  REQUIRE(records.size() == 7);
  CHECK(records[2].name == "1.3 may fail");
  CHECK_FALSE(records[2].success);
}

// Not tests: what the next one reads the report of. They fail, and are hidden for it.
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
TEST_CASE("1.5 throws where it asks", "[.report]") {
  const auto f = []() -> int { throw std::runtime_error("no value"); };
  REQUIRE(f() == 1);
}
TEST_CASE("1.6 checks nothing", "[.report]") {}
TEST_CASE("1.7 passes", "[.report]") {
  CHECK(true);
}

TEST_CASE("the report of the Catch2 that is installed here") {
  const auto program = grader::read_layout().build / "bin" / "grader_tests";
  const auto run = sandbox::run_process(
      {program.string(), "[.report]", "--reporter", "xml", "--warn", "NoAssertions"});
  const auto records = read_catch_xml(run.output);
  const auto record = [&](const std::string& task) {
    const auto found = std::find_if(records.begin(), records.end(),
                                    [&](auto& one) { return one.name.starts_with(task); });
    REQUIRE(found != records.end());
    return *found;
  };
  CHECK(records.size() == 7);
  CHECK(record("1.1").message == "REQUIRE(n < 2) was 3 < 2");
  CHECK(record("1.1").tags.find("[points:3]") != std::string::npos);
  CHECK(record("1.2").message.find("\"a\" == \"b\"") != std::string::npos);
  CHECK(record("1.3").message == "measured  1");
  CHECK(record("1.4").message == "no value");
  CHECK(record("1.5").message == "REQUIRE(f() == 1) threw: no value");
  CHECK(record("1.6").message == "this check checked nothing");
  for (const char* task : {"1.1", "1.2", "1.3", "1.4", "1.5", "1.6"}) {
    CHECK_FALSE(record(task).success);
  }
  CHECK(record("1.7").success);
}

TEST_CASE("a report that is not whole has no records") {
  CHECK(read_catch_xml("").empty());
  CHECK(read_catch_xml("not XML").empty());
  CHECK(read_catch_xml(head + "<Catch name=\"s\"></Catch>").empty());
  for (const std::string& report : {version_2, version_3}) {
    for (std::size_t size = 1; size + 1 < report.size(); size += 97) {
      CHECK(read_catch_xml(report.substr(0, size)).empty());
    }
  }
  // A case whose own end is missing is no success either.
  const auto records = read_catch_xml("<Catch><TestCase name=\"1.1 x\" tags=\"\"/></Catch>");
  REQUIRE(records.size() == 1);
  CHECK_FALSE(records[0].success);
}

}  // namespace mc::tests::xml
