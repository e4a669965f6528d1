// update: gets the course's latest version into a student's clone of the handout.

#include <filesystem>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "grader/base/errors.hpp"
#include "grader/base/text_file.hpp"
#include "grader/commands/command.hpp"
#include "grader/commands/manifest.hpp"
#include "runner/text.hpp"
#include "sandbox/printable.hpp"
#include "sandbox/process.hpp"

namespace mc::grader {
namespace {

namespace fs = std::filesystem;

/// git in one clone.
class Clone {
 public:
  explicit Clone(fs::path root) : root_(std::move(root)) {}

  sandbox::ProcessResult run(std::vector<std::string> words) const {
    // A rebase commits, and not every student has configured a name in git.
    words.insert(words.begin(), {"git", "-C", root_.string(), "-c", "user.useConfigOnly=false"});
    return sandbox::run_process(words);
  }
  /// The lines that a command prints; none if it fails.
  std::vector<std::string> lines(const std::vector<std::string>& words) const {
    const auto ran = run(words);
    std::vector<std::string> all;
    if (!ran.succeeded()) return all;
    for (const std::string_view line : text::split(ran.output, '\n')) {
      if (!line.empty()) all.emplace_back(line);
    }
    return all;
  }
  std::string line(const std::vector<std::string>& words) const {
    const auto all = lines(words);
    return all.empty() ? "" : all[0];
  }
  std::vector<std::string> in_conflict() const {
    return lines({"diff", "--name-only", "--diff-filter=U"});
  }

 private:
  fs::path root_;
};

/// After a pull whose uncommitted changes did not fit: the course's version in place, the student's
/// next to it. git kept the changes in its stash.
void keep_both(const Clone& clone, const fs::path& root, const std::vector<std::string>& files) {
  for (const std::string& file : files) {
    const auto mine = clone.run({"show", "stash@{0}:" + file});
    if (!mine.succeeded()) {
      throw UsageError(fmt::format("{} has conflicts; your changes are in git stash list", file));
    }
    write_text(root / (file + ".mine"), mine.output);
    clone.run({"checkout", "-q", "HEAD", "--", file});
    fmt::print(
        "{0}: you changed it, and so did the course. It is now the course's; yours is "
        "{0}.mine\n",
        sandbox::printable_line(file));
  }
  clone.run({"reset", "-q"});
  clone.run({"stash", "drop", "-q"});
}

int update(const Context& context, const Arguments& arguments) {
  if (!arguments.words.empty()) throw UsageError("usage: ./lab update");
  const fs::path& root = context.layout.root;
  const Clone clone(root);
  if (!fs::exists(root / ".git")) {
    throw UsageError("this is not a git clone: clone the course's repository to get updates");
  }
  const std::string remote = clone.line({"remote"});
  if (remote.empty()) {
    throw UsageError("this clone has no remote: git remote add origin ADDRESS, then ./lab update");
  }
  std::vector<std::string> pull{"pull", "-q", "--rebase", "--autostash"};
  if (clone.line({"rev-parse", "--abbrev-ref", "@{upstream}"}).empty()) {
    pull.insert(pull.end(), {remote, "main"});
  }
  const std::string before = clone.line({"rev-parse", "HEAD"});
  const auto pulled = clone.run(pull);
  const auto conflicts = clone.in_conflict();
  if (!pulled.succeeded()) {
    clone.run({"rebase", "--abort"});  // restores uncommitted changes as well
    if (conflicts.empty()) {
      throw MachineError("git pull: " + sandbox::printable(pulled.errors.substr(0, 600)));
    }
    throw UsageError(fmt::format(
        "nothing was updated: you committed changes to {}, and the course changed the same lines. "
        "To take the course's: git pull --no-rebase -X theirs",
        fmt::join(conflicts, ", ")));
  }
  keep_both(clone, root, conflicts);
  const std::string now = clone.line({"rev-parse", "HEAD"});
  if (now == before) {
    fmt::print("Already the latest: {}\n", read_manifest(root).version);
    return 0;
  }
  fmt::print("Now version {}. Your work is untouched.\n", read_manifest(root).version);
  // What the course says of its changes, the newest first.
  const auto fetched = clone.run({"log", "--format=%s%n%b", before + "..FETCH_HEAD"}).output;
  fmt::print("{}", sandbox::printable(fetched.substr(0, 2000)));
  return 0;
}

const RegisterCommand update_command{
    {"update",
     "update",
     {},
     "Gets the course's latest version: git pull --rebase, with your uncommitted work kept. Your\n"
     "files in starter/ and answers/ are never changed by the course. If you changed another file\n"
     "that the course changed too, yours is kept next to it as FILE.mine.\n",
     update}};

}  // namespace
}  // namespace mc::grader
