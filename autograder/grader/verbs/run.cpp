// run: one experiment by hand.

#include <filesystem>
#include <utility>

#include <fmt/format.h>

#include "grader/context/errors.hpp"
#include "grader/submission/build.hpp"
#include "grader/verbs/become.hpp"
#include "grader/verbs/verb.hpp"

namespace mc::grader {
namespace {

namespace fs = std::filesystem;

int run(const Context& context, const Arguments& arguments) {
  if (arguments.words.empty()) throw UsageError("usage: ./lab run LAB [EXPERIMENT ARGUMENT...]");
  const Lab& lab = find_lab(context.labs, arguments.words[0]);
  const fs::path directory = arguments.get("dir").value_or(context.layout.starter().string());
  const Submission submission = open_submission(context.labs, directory);
  const Built built = build_program(context.layout, lab, submission);
  if (!built.program) {
    fmt::print("{}\n", built.failure);
    return 1;
  }
  if (arguments.words.size() == 1) {
    fmt::print("The experiments of {}; run one with ./lab run {} NAME ARGUMENT...\n\n", lab.title(),
               lab.name);
    become({built.program->path, "--list"});
  }
  std::vector<std::string> command{built.program->path};
  command.insert(command.end(), arguments.words.begin() + 1, arguments.words.end());
  become(std::move(command));
}

const RegisterVerb run_verb{
    {"run",
     "run LAB [--dir DIR] [EXPERIMENT ARGUMENT...]",
     {"dir="},
     "Without EXPERIMENT: the experiments of the lab. Numbers are written 0.5, lists 1,2,4, "
     "structs\n"
     "3:0.5:2. Nothing is jailed here: it is your own program, on your own machine.\n"
     "  ./lab run variance mean 1,2,4\n",
     run,
     2}};

}  // namespace
}  // namespace mc::grader
