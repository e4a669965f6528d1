// gradescope: writes the zip that Gradescope builds its image from.

#include <algorithm>
#include <filesystem>
#include <system_error>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "grader/base/errors.hpp"
#include "grader/base/text_file.hpp"
#include "grader/commands/command.hpp"
#include "grader/commands/judging_options.hpp"
#include "grader/commands/tree.hpp"
#include "grader/judging/points.hpp"
#include "grader/submission/scratch.hpp"
#include "sandbox/printable.hpp"
#include "sandbox/process.hpp"

namespace mc::grader {
namespace {

namespace fs = std::filesystem;

/// Replaces the line of a shell script that sets this variable.
void set(std::string& script, const char* name, const std::string& value) {
  const std::string start = fmt::format("\n{}=", name);
  const auto at = script.find(start);
  if (at == std::string::npos) throw MachineError(fmt::format("run_autograder has no {}=", name));
  const auto begin = at + start.size();
  script.replace(begin, script.find('\n', begin) - begin, value);
}

/// Collects the content of the zip in a directory.
void lay_out(const Context& context, const Arguments& arguments, const std::string& labs,
             const fs::path& to) {
  const fs::path root = context.layout.root, place = root / "autograder" / "gradescope";
  const auto chosen = labs_and_those_below(context, labs);
  const JudgeForm form =
      has_compiled_judge(context.layout) ? JudgeForm::compiled : JudgeForm::sources;
  for (const std::string& file : files_without_answers(context, chosen, form)) {
    copy_into(root / file, to / file);
  }
  if (form == JudgeForm::compiled) {
    copy_compiled_judge(context, chosen, to);
  } else {  // setup.sh compiles it; there is no git history to give its version
    write_text(to / "VERSION.txt", context.layout.version + '\n');
  }
  if (fs::exists(root / points_file)) copy_into(root / points_file, to / points_file);
  if (arguments.has("leaderboard")) {  // only the leaderboard compares with the solutions
    for (const std::string& lab : chosen) {
      const fs::path file = fs::path("solutions") / find_lab(context.labs, lab).file();
      copy_into(root / file, to / file);
    }
  }
  for (const char* script : {"setup.sh", "run_autograder"}) copy_into(place / script, to / script);
  std::string run = read_whole_text(place / "run_autograder");
  set(run, "LAB", labs);
  set(run, "LEADERBOARD", arguments.has("leaderboard") ? "1" : "");
  set(run, "VISIBILITY", visibility_of(arguments).value_or(""));
  write_text(to / "run_autograder", run);
  for (const char* script : {"setup.sh", "run_autograder"}) {
    fs::permissions(to / script, fs::perms(0755));
  }
}

int gradescope(const Context& context, const Arguments& arguments) {
  const auto out = arguments.get("out");
  if (arguments.words.empty() || !out) {
    throw UsageError("usage: ./lab gradescope LAB... --out FILE.zip (./lab gradescope --help)");
  }
  require_writable(out);
  require_known_points(context.layout, context.labs);
  std::vector<std::string> names;
  for (const std::string& word : arguments.words) {
    const std::string& name = find_lab(context.labs, word).name;
    if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
  }
  const ScratchDirectory scratch(context.layout);
  const fs::path tree = scratch.path() / "tree", zip = fs::absolute(*out);
  lay_out(context, arguments, fmt::format("{}", fmt::join(names, ",")), tree);

  // Packed in a temporary directory and renamed: the zip is always complete.
  const fs::path aside = zip.string() + ".new";
  std::vector<std::string> command{"cmake", "-E", "tar", "cf", aside.string(), "--format=zip"};
  for (const auto& entry : fs::directory_iterator(tree)) {
    command.push_back(entry.path().filename().string());
  }
  const auto made = sandbox::run_process(command, {.directory = tree});
  if (!made.succeeded()) {
    std::error_code ignored;
    fs::remove(aside, ignored);
    throw MachineError(
        fmt::format("cannot write {}: {}", zip.string(), sandbox::printable_line(made.errors)));
  }
  fs::rename(aside, zip);
  fmt::print("{}: {}, version {}\n", sandbox::printable_line(zip.string()), fmt::join(names, ", "),
             context.layout.version);
  fmt::print("Upload it to Gradescope as the autograder of an assignment (Ubuntu 22.04).\n");
  return 0;
}

const RegisterCommand gradescope_command{
    {"gradescope",
     "gradescope LAB... --out FILE.zip [--visibility V] [--leaderboard]",
     {"out=", "visibility=", "leaderboard"},
     "Writes the autograder of an assignment with these labs; a missing file earns 0 points. The\n"
     "zip file has everything that the labs need, with setup.sh and run_autograder at its top,\n"
     "but no solutions.\n"
     "  --out FILE.zip  where to write it\n"
     "  --visibility V  when students see the checks: visible, hidden, after_due_date,\n"
     "                  after_published\n"
     "  --leaderboard   a leaderboard of speed for the whole class; the zip file then has the "
     "reference\n",
     gradescope}};

}  // namespace
}  // namespace mc::grader
