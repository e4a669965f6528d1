// setup: what it does, the entry script has done when this is run.

#include <fmt/format.h>

#include "grader/base/errors.hpp"
#include "grader/commands/command.hpp"

namespace mc::grader {
namespace {

int setup(const Context&, const Arguments& arguments) {
  if (!arguments.words.empty()) throw UsageError("usage: ./lab setup");
  fmt::print("Everything is here and built.\n");
  return 0;
}

const RegisterCommand setup_command{
    {"setup",
     "setup",
     {},
     "With apt, dnf or brew; it says what it runs. At a terminal it asks first, without one or "
     "with\n"
     "CI=true it does not. Where nothing is missing, nothing is touched.\n",
     setup}};

}  // namespace
}  // namespace mc::grader
