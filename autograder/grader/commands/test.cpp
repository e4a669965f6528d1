// test: the repository's own tests.

#include <cstdlib>
#include <filesystem>

#include "grader/base/errors.hpp"
#include "grader/commands/become.hpp"
#include "grader/commands/command.hpp"

namespace mc::grader {
namespace {

int test(const Context& context, const Arguments& arguments) {
  if (!arguments.words.empty())
    throw UsageError("usage: ./lab test [--quick | --all | --full] [--power]");
  const std::string programs = (context.layout.build / "bin").string() + '/';
  if (arguments.has("mutants")) {
    const auto text = [&](const char* option, std::uint64_t otherwise) {
      return std::to_string(arguments.number(option).value_or(otherwise));
    };
    become({programs + "self_test", "mutants", *arguments.get("mutants"), text("sample", 300),
            text("seed", 1)});
  }
  if (arguments.has("power") && !arguments.has("full")) {
    become({programs + "self_test", "power"});
  }
  if (arguments.has("all") || arguments.has("full")) setenv("MC_UNCHANGED_TOO", "1", 1);
  if (arguments.has("full")) {
    setenv("MC_SEEDS", "1000", 1);
    setenv("MC_MISTAKE_SEEDS", "200", 1);
  }
  become({"cmake", "-D", "BUILD=" + context.layout.build.string(), "-D",
          std::string("FULL=") + (arguments.has("full") ? "ON" : "OFF"), "-D",
          std::string("QUICK=") + (arguments.has("quick") ? "ON" : "OFF"), "-D",
          std::string("POWER=") + (arguments.has("power") ? "ON" : "OFF"), "-P",
          (context.layout.root / "cmake" / "test.cmake").string()});
}

const RegisterCommand test_command{
    {"test",
     "test [--quick | --all | --full] [--power] [--mutants LAB]",
     {"quick", "all", "full", "power", "mutants=", "sample=", "seed="},
     "Judges every submission of the repository: the starters, the solutions, the mistakes, the\n"
     "alternatives, the attacks. Skips those that passed unless they, the checks or the grader\n"
     "changed since.\n"
     "  --all     skip none\n"
     "  --quick   under a minute: the grader's own tests, without those that build a checkout\n"
     "            or measure, one submission of every kind, and a mistake of every lab\n"
     "  --full    right answers with 1,000 seeds (their checks that are not random with 2,000),\n"
     "            mistakes with 200 (the checks of their tasks): takes a night, and continues "
     "after\n"
     "            an interruption\n"
     "  --power   print the seeds and alphas that runs of --full have recorded\n"
     "  --mutants LAB [--sample N] [--seed S]\n"
     "            small changes to right answers of a lab, 300 by default: a check should\n"
     "            fail each of them; lists the survivors and ends with the score\n",
     test}};

}  // namespace
}  // namespace mc::grader
