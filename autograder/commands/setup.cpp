// setup: in a checkout, the entry script has done the work before this runs. A handout compiles
// what all submissions of a lab share.

#include "commands/command.hpp"
#include "judge/submission/from_source.hpp"
#include "sandbox/process.hpp"

namespace mc::grader {
namespace {

int setup(const Context& context, const Arguments&) {
  if (context.layout.judge_is_compiled) {
    for (const Lab& lab : context.labs) shared_objects(context.layout, lab);
    if (!sandbox::run_process({"gnuplot", "--version"}).succeeded()) {
      fmt::print("Ready, but without plots: install gnuplot (sudo apt install gnuplot-nox).\n");
      return 0;
    }
  }
  fmt::print("Everything is here and built.\n");
  return 0;
}

const RegisterCommand setup_command{
    {.usage = "setup",
     .about = "install what is missing and build everything",
     .details = "Uses apt or dnf, and prints what it runs. Asks first at a terminal, but not "
                "without one or with CI=true. Changes nothing if nothing is missing.",
     .run = setup,
     .most_words = 0,
     .targets = [](const Context&, const Arguments&) { return std::vector<std::string>{"all"}; }}};

}  // namespace
}  // namespace mc::grader
