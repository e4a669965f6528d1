// test: the repository's own tests.

#include <cstdlib>
#include <filesystem>

#include <fmt/format.h>

#include "grader/context/errors.hpp"
#include "grader/verbs/become.hpp"
#include "grader/verbs/verb.hpp"

namespace mc::grader {
namespace {

namespace fs = std::filesystem;

int test(const Context& context, const Arguments& arguments) {
  if (!arguments.words.empty()) throw UsageError("usage: ./lab test [--full]");
  if (arguments.has("full")) setenv("MC_SEEDS", "1000", 1);
  become({"cmake", "-D", "BUILD=" + context.layout.build.string(), "-P",
          (context.layout.root / "cmake" / "test.cmake").string()});
}

const RegisterVerb test_verb{
    {"test",
     "test [--full]",
     {"full"},
     "Every submission of the repository is judged: the starter, the solutions, the mistakes, "
     "the\n"
     "alternatives, the attacks. With --full, right ones with 1,000 seeds: hours, but it goes on "
     "where\n"
     "it was interrupted.\n",
     test}};

}  // namespace
}  // namespace mc::grader
