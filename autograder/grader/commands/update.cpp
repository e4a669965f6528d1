// update: gets the course's latest version into a student's clone of the handout.

#include "grader/commands/git.hpp"
#include "grader/commands/manifest.hpp"

namespace mc::grader {
namespace {

/// After a pull whose uncommitted changes did not fit: the course's version in place, the student's
/// next to it. git kept the changes in its stash.
void keep_both(const fs::path& root, const std::vector<std::string>& files) {
  if (files.empty()) return;  // the newest stash, if any, is the student's
  for (const std::string& file : files) {
    const auto own = run_git(root, {"show", "stash@{0}:" + file});
    if (!own.succeeded()) {
      throw UsageError(fmt::format("{} has conflicts; your changes are in git stash list", file));
    }
    write_text(root / (file + ".mine"), own.output);
    run_git(root, {"checkout", "-q", "HEAD", "--", file});
    fmt::print(
        "{0}: you changed it, and so did the course. It is now the course's; yours is "
        "{0}.mine\n",
        sandbox::printable_line(file));
  }
  run_git(root, {"reset", "-q"});
  run_git(root, {"stash", "drop", "-q"});
}

int update(const Context& context, const Arguments&) {
  const fs::path& root = context.layout.root;
  if (!fs::exists(root / ".git")) {
    throw UsageError("this is not a git clone: clone the course's repository to get updates");
  }
  const auto remotes = git_lines(root, {"remote"});
  if (remotes.empty()) {
    throw UsageError("this clone has no remote: git remote add origin ADDRESS, then ./lab update");
  }
  std::vector<std::string> pull{"pull", "-q", "--rebase", "--autostash"};
  if (git_lines(root, {"rev-parse", "--abbrev-ref", "@{upstream}"}).empty()) {
    pull.insert(pull.end(), {remotes[0], "main"});
  }
  const auto before = git_lines(root, {"rev-parse", "HEAD"});
  const auto pulled = run_git(root, pull);
  const auto conflicts = git_lines(root, {"diff", "--name-only", "--diff-filter=U"});
  if (!pulled.succeeded()) {
    run_git(root, {"rebase", "--abort"});  // restores uncommitted changes as well
    if (conflicts.empty()) {
      throw MachineError("git pull: " + sandbox::printable(pulled.errors.substr(0, 600)));
    }
    throw UsageError(fmt::format(
        "nothing was updated: you committed changes to {}, and the course changed the same lines. "
        "To take the course's: git pull --no-rebase -X theirs",
        fmt::join(conflicts, ", ")));
  }
  keep_both(root, conflicts);
  if (git_lines(root, {"rev-parse", "HEAD"}) == before) {
    fmt::print("Already the latest: {}\n", read_manifest(root).version);
    return 0;
  }
  fmt::print("Now version {}. Your work is untouched.\n", read_manifest(root).version);
  // The course's messages on its changes, the newest first.
  const std::string range = before.empty() ? "FETCH_HEAD" : before[0] + "..FETCH_HEAD";
  const auto messages = run_git(root, {"log", "--format=%s%n%b", range}).output;
  fmt::print("{}", sandbox::printable(messages.substr(0, 2000)));
  return 0;
}

const RegisterCommand update_command{
    {.usage = "update",
     .details =
         "Gets the course's latest version: git pull --rebase, with your uncommitted work kept. "
         "Your files in starter/ and answers/ are never changed by the course. If you changed "
         "another file that the course changed too, yours is kept next to it as FILE.mine.",
     .run = update,
     .most_words = 0}};

}  // namespace
}  // namespace mc::grader
