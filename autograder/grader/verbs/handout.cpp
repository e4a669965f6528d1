// handout: what students get, as a fresh git repository.

#include <algorithm>
#include <filesystem>
#include <set>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "grader/context/errors.hpp"
#include "grader/context/text_file.hpp"
#include "grader/verbs/verb.hpp"
#include "runner/text.hpp"
#include "sandbox/printable.hpp"
#include "sandbox/process.hpp"

namespace mc::grader {
namespace {

namespace fs = std::filesystem;

/// What holds answers, or is of use to instructors only.
constexpr const char* kept_back[] = {"solutions/",
                                     "docs/",
                                     "autograder/submissions/",
                                     "autograder/tests/",
                                     "autograder/bench/",
                                     "autograder/gradescope/",
                                     ".ci/",
                                     ".github/",
                                     "README.md",
                                     "CONTRIBUTING.md",
                                     "CHANGELOG.md",
                                     "CITATION.cff"};

/// Runs git there; throws MachineError where it fails.
std::string git(const fs::path& directory, std::vector<std::string> words) {
  words.insert(words.begin(), {"git", "-C", directory.string()});
  const auto run = sandbox::run_process(words);
  if (!run.succeeded()) {
    throw MachineError(fmt::format("{}: {}", fmt::join(words, " "),
                                   sandbox::printable_line(run.errors.substr(0, 200))));
  }
  return run.output;
}

/// The labs named "1,2", and those they stand on; all without a list.
std::set<std::string> chosen_labs(const Context& context, const Arguments& arguments) {
  std::set<std::string> chosen;
  const auto list = arguments.get("labs");
  if (!list) {
    for (const Lab& lab : context.labs) chosen.insert(lab.name);
    return chosen;
  }
  for (const std::string_view word : text::split(*list, ',')) {
    const Lab& lab = find_lab(context.labs, std::string(word));
    chosen.insert(lab.name);
    chosen.insert(lab.stands_on.begin(), lab.stands_on.end());
  }
  return chosen;
}

/// Is this file of a lab that is not handed out?
bool is_left_out(const Context& context, const std::set<std::string>& chosen,
                 const std::string& file) {
  for (const Lab& lab : context.labs) {
    if (chosen.contains(lab.name)) continue;
    for (const std::string& place : {"labs/" + lab.folder + '/', "starter/" + lab.file(),
                                     "autograder/checks/" + lab.name + '/'}) {
      if (file.starts_with(place)) return true;
    }
  }
  return false;
}

int handout(const Context& context, const Arguments& arguments) {
  if (arguments.words.size() != 1) throw UsageError("usage: ./lab handout DIR [--labs 1,2,…]");
  const fs::path to = fs::absolute(arguments.words[0]), root = context.layout.root;
  if (fs::exists(to) && !fs::is_empty(to)) {
    throw UsageError(fmt::format("{} is not empty", sandbox::printable_line(to.string())));
  }
  const auto chosen = chosen_labs(context, arguments);
  std::size_t count = 0;
  const auto copy = [&](const fs::path& from, const fs::path& name) {
    fs::create_directories((to / name).parent_path());
    fs::copy_file(from, to / name);
    ++count;
  };
  // Only what git knows: no build, no file of one's own.
  const std::string listed = git(root, {"ls-files", "-z"});
  for (const std::string_view name : text::split(listed, '\0')) {
    const std::string file(name);
    const bool kept = std::any_of(std::begin(kept_back), std::end(kept_back),
                                  [&](const char* place) { return file.starts_with(place); });
    if (file.empty() || kept || is_left_out(context, chosen, file)) continue;
    copy(root / file, file);
  }
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
