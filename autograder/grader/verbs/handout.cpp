// handout: what students get, as a fresh git repository.

#include <filesystem>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "grader/context/errors.hpp"
#include "grader/verbs/tree.hpp"
#include "grader/verbs/verb.hpp"
#include "sandbox/printable.hpp"

namespace mc::grader {
namespace {

namespace fs = std::filesystem;

int handout(const Context& context, const Arguments& arguments) {
  if (arguments.words.size() != 1) throw UsageError("usage: ./lab handout DIR [--labs 1,2,…]");
  const fs::path to = fs::absolute(arguments.words[0]), root = context.layout.root;
  if (fs::exists(to) && !fs::is_empty(to)) {
    throw UsageError(fmt::format("{} is not empty", sandbox::printable_line(to.string())));
  }
  const auto chosen = labs_and_those_below(context, arguments.get("labs"));
  std::size_t count = 0;
  const auto copy = [&](const fs::path& from, const fs::path& name) {
    copy_into(from, to / name);
    ++count;
  };
  for (const std::string& file : files_without_answers(context, chosen)) copy(root / file, file);
  const fs::path extra = root / "docs" / "handout";
  for (const auto& entry : fs::recursive_directory_iterator(extra)) {
    if (entry.is_regular_file()) copy(entry.path(), fs::relative(entry.path(), extra));
  }
  git(to, {"init", "-q", "-b", "main"});
  git(to, {"add", "-A"});
  git(to, {"-c", "user.name=course", "-c", "user.email=course@localhost", "commit", "-q", "-m",
           "Monte Carlo labs " + context.layout.version});
  fmt::print("{}: {} files, one commit, labs {}\n", sandbox::printable_line(to.string()), count,
             fmt::join(chosen, ", "));
  return 0;
}

const RegisterVerb handout_verb{
    {"handout",
     "handout DIR [--labs 1,2,…]",
     {"labs="},
     "Labs, starters, the grader and its checks, and a README for students, as a git repository "
     "with\n"
     "one commit. No solutions, no submissions, no tests of the repository. An editor's tasks, a\n"
     "dev container, and a workflow that grades on each push are in it.\n"
     "  --labs LIST   these labs and those that they stand on; all without it\n",
     handout}};

}  // namespace
}  // namespace mc::grader
