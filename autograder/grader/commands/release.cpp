// release: adds a lab's solution and answers to a handout, after its deadline.

#include "grader/commands/git.hpp"
#include "grader/commands/tree.hpp"
#include "grader/commands/upgrade.hpp"

namespace mc::grader {
namespace {

int release(const Context& context, const Arguments& arguments) {
  const Lab& lab = find_lab(context.labs, arguments.words[0]);
  const fs::path handout = arguments.words[1];
  const std::string shown = sandbox::printable_line(handout.string());
  const Manifest manifest = read_manifest(handout);
  if (manifest.version.empty()) {
    throw UsageError(shown + " is not a handout: ./lab handout writes one");
  }
  if (!manifest.labs.contains(lab.name)) {
    throw UsageError(fmt::format("{} does not have lab {}", shown, lab.name));
  }
  std::vector<std::string> files;
  for (const fs::path& from : {context.layout.solutions() / lab.file(),
                               context.layout.root / "docs" / "answers" / (lab.folder + ".md")}) {
    if (!fs::exists(from)) continue;
    files.push_back("released/" + from.filename().string());
    copy_into(from, handout / files.back());
  }
  if (git(handout, {"status", "--porcelain", "--", "released"}).empty()) {
    fmt::print("{} already has it\n", shown);
    return 0;
  }
  commit_files(handout, files, fmt::format("Release the solution of lab {}", lab.name));
  fmt::print("{}: one commit with {}\n", shown, fmt::join(files, ", "));
  return 0;
}

const RegisterCommand release_command{
    {.usage = "release LAB DIR",
     .details = "Adds a commit to the handout in DIR: released/LAB.cpp, the solution, and "
                "released/N-LAB.md, the answers to the written questions. ./lab plot LAB released "
                "compares with it.",
     .run = release,
     .least_words = 2,
     .most_words = 2}};

}  // namespace
}  // namespace mc::grader
