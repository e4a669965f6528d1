// reset: restores the starter of a lab.

#include "grader/commands/git.hpp"

namespace mc::grader {
namespace {

std::size_t unwritten_tasks(const std::string& text) {
  std::size_t count = 0;
  for (auto at = text.find("todo("); at != text.npos; at = text.find("todo(", at + 1)) ++count;
  return count;
}

/// The newest committed version of a file with the most unwritten tasks.
std::string pristine(const fs::path& root, const std::string& file) {
  std::string best;
  for (const std::string& commit : git_lines(root, {"log", "--format=%H", "--", file})) {
    const auto version = run_git(root, {"show", commit + ':' + file});
    if (version.succeeded() && unwritten_tasks(version.output) > unwritten_tasks(best)) {
      best = version.output;
    }
  }
  if (best.empty()) {
    throw MachineError(fmt::format("git has no {} here: download it from the course's page", file));
  }
  return best;
}

int reset(const Context& context, const Arguments& arguments) {
  const Lab& lab = find_lab(context.labs, arguments.words[0]);
  const std::string name = "starter/" + lab.file();
  const std::string original = pristine(context.layout.root, name);
  const fs::path file = context.layout.root / name;
  if (fs::exists(file) && read_text(file) != original) {
    fs::path backup;
    for (int i = 1; backup.empty() || fs::exists(backup); ++i) {
      backup = file.string() + fmt::format(".{}.bak", i);
    }
    fs::copy_file(file, backup);
    fmt::print("Your file is kept as {}.\n", backup.string());
  }
  write_text(file, original);
  fmt::print("{} is the original again.\n", name);
  return 0;
}

const RegisterCommand reset_command{
    {.usage = "reset LAB",
     .details = "Restores the newest version in git's history that has no solved task.",
     .run = reset,
     .least_words = 1,
     .most_words = 1}};

}  // namespace
}  // namespace mc::grader
