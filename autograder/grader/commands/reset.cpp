// reset: restores the starter of a lab.

#include <filesystem>

#include <fmt/format.h>

#include "grader/base/errors.hpp"
#include "grader/base/text_file.hpp"
#include "grader/commands/command.hpp"
#include "runner/text.hpp"
#include "sandbox/process.hpp"

namespace mc::grader {
namespace {

namespace fs = std::filesystem;

std::size_t count(const std::string& text, const std::string& what) {
  std::size_t found = 0;
  for (auto at = text.find(what); at != std::string::npos; at = text.find(what, at + 1)) ++found;
  return found;
}

/// The newest committed version of a file with the most unwritten tasks.
std::string pristine(const Context& context, const std::string& file) {
  const std::string root = context.layout.root.string();
  const auto commits =
      sandbox::run_process({"git", "-C", root, "log", "--format=%H", "--", "starter/" + file});
  std::string best;
  for (const std::string_view commit : text::split(commits.output, '\n')) {
    if (commit.empty()) continue;
    const auto version = sandbox::run_process(
        {"git", "-C", root, "show", fmt::format("{}:starter/{}", commit, file)});
    if (version.succeeded() && count(version.output, "todo(") > count(best, "todo(")) {
      best = version.output;
    }
  }
  if (best.empty()) {
    throw MachineError(
        fmt::format("git has no starter/{} here: download it from the course's page", file));
  }
  return best;
}

int reset(const Context& context, const Arguments& arguments) {
  if (arguments.words.size() != 1) throw UsageError("usage: ./lab reset LAB");
  const Lab& lab = find_lab(context.labs, arguments.words[0]);
  const std::string fresh = pristine(context, lab.file());
  const fs::path file = context.layout.starter() / lab.file();
  if (fs::exists(file)) {
    if (read_text(file) == fresh) {
      fmt::print("starter/{} is the original again.\n", lab.file());
      return 0;
    }
    fs::path backup;
    for (int i = 1; backup.empty() || fs::exists(backup); ++i) {
      backup = file.string() + fmt::format(".{}.bak", i);
    }
    fs::copy_file(file, backup);
    fmt::print("Your file is kept as {}.\n", backup.string());
  }
  write_text(file, fresh);
  fmt::print("starter/{} is the original again.\n", lab.file());
  return 0;
}

const RegisterCommand reset_command{
    {"reset",
     "reset LAB",
     {},
     "Restores the newest version in git's history that has no solved task.\n",
     reset}};

}  // namespace
}  // namespace mc::grader
