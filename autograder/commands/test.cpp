// test: the repository's own tests.

#include <cstdlib>

#include "commands/command.hpp"
#include "judge/base/side_by_side.hpp"

namespace mc::grader {
namespace {

int test(const Context& context, const Arguments& arguments) {
  if (arguments.has("all")) setenv("MC_UNCHANGED_TOO", "1", 1);
  execute({"cmake", "-DBUILD=" + context.layout.build.string(),
           fmt::format("-DQUICK={}", arguments.has("quick") ? "ON" : "OFF"),
           fmt::format("-DJOBS={}", cores()), "-P",
           (context.layout.root / "cmake" / "test.cmake").string()});
}

const RegisterCommand test_command{
    {.usage = "test [--quick | --all]",
     .about = "run the repository's own tests",
     .details = "ctest with counts: judges every submission of the repository, the starters, the "
                "solutions, the mistakes, the alternatives, the attacks. Skips those that passed "
                "unless they, the checks or the judge changed since.",
     .options = {{"--all", "skip none"},
                 {"--quick",
                  "under a minute: the judge's own tests, without those that build a checkout or "
                  "measure, one submission of every kind, and a mistake of every lab"}},
     .run = test,
     .most_words = 0,
     .for_instructors = true,
     .place = "autograder/tests",
     .targets = [](const Context&, const Arguments&) { return std::vector<std::string>{"all"}; }}};

}  // namespace
}  // namespace mc::grader
