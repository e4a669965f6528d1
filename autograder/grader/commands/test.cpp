// test: the repository's own tests.

#include <cstdlib>

#include "grader/commands/command.hpp"

namespace mc::grader {
namespace {

int test(const Context& context, const Arguments& arguments) {
  const std::string programs = (context.layout.build / "bin").string() + '/';
  const bool is_full = arguments.has("full");
  if (const auto lab = arguments.get("mutants")) {
    execute({programs + "self_test", "mutants", *lab,
             std::to_string(arguments.number("sample").value_or(300)),
             std::to_string(arguments.number("seed").value_or(1))});
  }
  if (arguments.has("power") && !is_full) execute({programs + "self_test", "power"});
  if (arguments.has("all") || is_full) setenv("MC_UNCHANGED_TOO", "1", 1);
  if (is_full) {
    setenv("MC_SEEDS", "1000", 1);
    setenv("MC_MISTAKE_SEEDS", "200", 1);
  }
  const auto define = [&](const char* name, const char* option) {
    return fmt::format("-D{}={}", name, arguments.has(option) ? "ON" : "OFF");
  };
  execute({"cmake", "-DBUILD=" + context.layout.build.string(), define("FULL", "full"),
           define("QUICK", "quick"), define("POWER", "power"), "-P",
           (context.layout.root / "cmake" / "test.cmake").string()});
}

const RegisterCommand test_command{
    {.usage = "test [--quick | --all | --full] [--power] [--mutants LAB]",
     .details = "Judges every submission of the repository: the starters, the solutions, the "
                "mistakes, the alternatives, the attacks. Skips those that passed unless they, the "
                "checks or the grader changed since.",
     .options = {{"--all", "skip none"},
                 {"--quick",
                  "under a minute: the grader's own tests, without those that build a checkout or "
                  "measure, one submission of every kind, and a mistake of every lab"},
                 {"--full",
                  "right answers with 1,000 seeds (their checks that are not random with 2,000), "
                  "mistakes with 200 (the checks of their tasks): takes a night, and continues "
                  "after an interruption"},
                 {"--power", "print the seeds and alphas that runs of --full have recorded"},
                 {"--mutants LAB",
                  "small changes to right answers of a lab: a check should fail each of them; "
                  "lists the survivors and ends with the score"},
                 {"--sample N", "with --mutants: the number of changes (300)"},
                 {"--seed S", "with --mutants: which changes (1)"}},
     .run = test,
     .most_words = 0}};

}  // namespace
}  // namespace mc::grader
