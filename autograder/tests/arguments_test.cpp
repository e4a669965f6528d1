// A command's words and options, in every order.
#include <string>
#include <vector>

#include "checks/support/catch.hpp"
#include "commands/arguments.hpp"
#include "judge/base/errors.hpp"

namespace mc::tests::words {

using namespace grader;

namespace {

using Words = std::vector<std::string>;

/// Arguments of `run`: after two words, the rest belongs to the experiment.
Arguments of_run(const Words& words) {
  return parse_arguments(words, {{"--dir DIR", "--sanitize"}, 2});
}

}  // namespace

TEST_CASE("options may come before, between, or after the words") {
  for (const Words& words : {Words{"--seed", "7", "variance", "try"},
                             {"variance", "--seed", "7", "try"},
                             {"variance", "try", "--seed", "7"},
                             {"variance", "try", "--seed=7"}}) {
    const Arguments arguments = parse_arguments(words, {{"--seed S", "--no-plots"}});
    CAPTURE(words);
    CHECK(arguments.words == Words{"variance", "try"});
    CHECK(arguments.number("seed") == 7u);
    CHECK_FALSE(arguments.has("no-plots"));
  }
}

TEST_CASE("after an experiment's name there are no options") {
  for (const Words& words : {Words{"variance", "--dir", "try", "mean", "-1,-2", "--dir"},
                             {"--dir", "try", "variance", "mean", "-1,-2", "--dir"},
                             {"--dir=try", "variance", "mean", "-1,-2", "--dir"}}) {
    const Arguments arguments = of_run(words);
    CAPTURE(words);
    CHECK(arguments.words == Words{"variance", "mean", "-1,-2", "--dir"});
    CHECK(arguments.get("dir") == "try");
  }
  const Arguments both = of_run({"--sanitize", "variance", "--dir", "try", "mean", "1"});
  CHECK(both.words == Words{"variance", "mean", "1"});
  CHECK(both.has("sanitize"));
  CHECK(both.get("dir") == "try");
}

TEST_CASE("after two dashes there are no options") {
  const Arguments arguments = of_run({"variance", "--", "--dir", "x"});
  CHECK(arguments.words == Words{"variance", "--dir", "x"});
  CHECK_FALSE(arguments.has("dir"));
}

TEST_CASE("a short option's value may be attached or the next word") {
  for (const Words& words : {Words{"-j", "4", "a"}, {"-j4", "a"}, {"a", "--jobs", "4"}}) {
    const Arguments arguments = parse_arguments(words, {{"--jobs N, -j N"}});
    CHECK(arguments.words == Words{"a"});
    CHECK(arguments.number("jobs") == 4u);
  }
}

TEST_CASE("a lab, a task, or both") {
  const std::vector<Lab> labs{{1, "variance", "1-variance", {}}, {10, "paths", "10-paths", {}}};
  const auto meant = [&](const Words& words) { return lab_and_task(labs, words); };
  CHECK(meant({"variance"}).task.empty());
  CHECK(meant({"10.12"}).lab.name == "paths");
  CHECK(meant({"10.12"}).task == "10.12");
  CHECK(meant({"1-variance", "1.10", "try"}).task == "1.10");
  CHECK(meant({"1-variance", "1.10", "try"}).rest == Words{"try"});
  CHECK(meant({"1.1", "try"}).rest == Words{"try"});
  CHECK(meant({"1", "./1.3"}).rest == Words{"./1.3"});  // a directory
  CHECK(meant({"1", "./1.3"}).task.empty());
  CHECK_THROWS_AS(meant({"2.1"}), UsageError);
  CHECK_THROWS_AS(meant({"variance", "10.1"}), UsageError);
  CHECK_THROWS_AS(meant({"1.3.2"}), UsageError);
}

}  // namespace mc::tests::words
