// release: adds a lab's solution and answers to a handout, after its deadline.

#include <filesystem>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "grader/base/errors.hpp"
#include "grader/commands/command.hpp"
#include "grader/commands/tree.hpp"
#include "grader/commands/upgrade.hpp"
#include "sandbox/printable.hpp"

namespace mc::grader {
namespace {

namespace fs = std::filesystem;

int release(const Context& context, const Arguments& arguments) {
  if (arguments.words.size() != 2) throw UsageError("usage: ./lab release LAB DIR");
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
  const auto add = [&](const fs::path& from, const std::string& name) {
    if (!fs::exists(from)) return;
    fs::remove(handout / name);
    copy_into(from, handout / name);
    files.push_back(name);
  };
  add(context.layout.solutions() / lab.file(), "released/" + lab.file());
  const std::string answers = lab.folder + ".md";
  add(context.layout.root / "docs" / "answers" / answers, "released/" + answers);
  if (git(handout, {"status", "--porcelain", "--", "released"}).empty()) {
    fmt::print("{} already has it\n", shown);
    return 0;
  }
  commit_files(handout, files, fmt::format("Release the solution of lab {}", lab.name));
  fmt::print("{}: one commit with {}\n", shown, fmt::join(files, ", "));
  return 0;
}

const RegisterCommand release_command{
    {"release",
     "release LAB DIR",
     {},
     "Adds a commit to the handout in DIR: released/LAB.cpp, the solution, and released/N-LAB.md,\n"
     "the answers to the written questions. ./lab plot LAB released compares with it.\n",
     release}};

}  // namespace
}  // namespace mc::grader
