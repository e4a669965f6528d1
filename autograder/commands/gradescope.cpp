// gradescope: writes the zip that Gradescope builds its image from.

#include <algorithm>

#include "commands/command.hpp"
#include "commands/course_copy.hpp"
#include "judge/judging/points.hpp"
#include "judge/submission/scratch.hpp"
#include "sandbox/process.hpp"

namespace mc::grader {
namespace {

/// Replaces the line of a shell script that sets this variable.
void set_variable(std::string& script, const char* name, const std::string& value) {
  const std::string start = fmt::format("\n{}=", name);
  const auto at = script.find(start);
  if (at == std::string::npos) throw MachineError(fmt::format("run_autograder has no {}=", name));
  const auto begin = at + start.size();
  script.replace(begin, script.find('\n', begin) - begin, value);
}

/// Collects the content of the zip in a directory.
void write_tree(const Context& context, const std::string& labs, const fs::path& to) {
  const fs::path root = context.layout.root;
  const auto chosen = labs_with_dependencies(context, labs);
  const JudgeForm form =
      has_compiled_judge(context.layout) ? JudgeForm::compiled : JudgeForm::sources;
  copy_course(context, chosen, form, to);
  if (form == JudgeForm::sources) {  // setup.sh compiles it; git cannot tell its version
    write_text(to / "VERSION.txt", context.layout.version + '\n');
  }
  const fs::path scripts = root / "autograder" / "gradescope";
  std::string run = read_whole_text(scripts / "run_autograder");
  set_variable(run, "LAB", labs);
  write_text(to / "run_autograder", run);
  write_text(to / "setup.sh", read_whole_text(scripts / "setup.sh"));
  for (const char* script : {"setup.sh", "run_autograder"}) {
    fs::permissions(to / script, fs::perms(0755));
  }
}

int gradescope(const Context& context, const Arguments& arguments) {
  const auto out = arguments.output("out");
  if (!out) throw WrongUsage();
  require_known_points(context.layout, context.labs);
  std::vector<std::string> names;
  for (const std::string& word : arguments.words) {
    const std::string& name = find_lab(context.labs, word).name;
    if (std::ranges::find(names, name) == names.end()) names.push_back(name);
  }
  const ScratchDirectory scratch(context.layout);
  const fs::path tree = scratch.path() / "tree", zip = fs::absolute(*out);
  write_tree(context, fmt::format("{}", fmt::join(names, ",")), tree);

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
    {.usage = "gradescope LAB... --out FILE.zip",
     .about = "write the zip file for Gradescope's autograder",
     .details =
         "Writes the autograder of an assignment with these labs; a missing file earns 0 points. "
         "The zip file has everything that the labs need, with setup.sh and run_autograder at its "
         "top, but no solutions.",
     .options = {{"--out FILE.zip", "where to write it"}},
     .run = gradescope,
     .least_words = 1,
     .for_instructors = true,
     .place = "autograder/gradescope",
     .targets = [](const Context&, const Arguments&) {
       return std::vector<std::string>{"handout_judge"};
     }}};

}  // namespace
}  // namespace mc::grader
