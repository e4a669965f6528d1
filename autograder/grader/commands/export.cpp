// export: arranges a class's files for another tool.

#include <map>

#include "grader/base/shell.hpp"
#include "grader/commands/command.hpp"
#include "grader/submission/intake.hpp"
#include "grader/submission/scratch.hpp"
#include "grader/submission/source.hpp"

namespace mc::grader {
namespace {

using Files = std::map<std::string, fs::path>;  // lab name -> file

void copy_files(const Context& context, const Files& files, const fs::path& to) {
  fs::create_directories(to);
  for (const auto& [lab, file] : files) {
    const SourceFile source = read_source(file);
    if (!source.problem.empty()) {
      fmt::print("left out: {}: {}\n", to.filename().string(), source.problem);
      continue;
    }
    write_text(to / find_lab(context.labs, lab).file(), source.text);
  }
}

Files starters(const Context& context) {
  Files files;
  for (const Lab& lab : context.labs) {
    const fs::path file = context.layout.starter() / lab.file();
    if (fs::exists(file)) files[lab.name] = file;
  }
  return files;
}

int export_class(const Context& context, const Arguments& arguments) {
  const auto out = arguments.get("out");
  if (arguments.words[0] != "jplag" || !out) throw WrongUsage();
  const fs::path to = *out;
  if (fs::exists(to) && (!fs::is_directory(to) || !fs::is_empty(to))) {
    throw UsageError(fmt::format("{} is not empty", sandbox::printable_line(to.string())));
  }
  sweep_scratch(context.layout);
  const Intake intake = take_in(context, arguments.words_after(1), Meaning::many);
  std::size_t count = 0;
  for (const IntakeEntry& one : intake.entries) {
    const Submission& submission = one.submission;
    if (!one.unreadable.empty() || submission.files.empty()) {
      fmt::print("left out: {}: {}\n", submission.label,
                 one.unreadable.empty() ? "it contains no lab files" : one.unreadable);
      continue;
    }
    copy_files(context, submission.files, to / "submissions" / submission.label);
    ++count;
  }
  if (count == 0) throw UsageError("there are no lab files");
  copy_files(context, starters(context), to / "base-code");
  fmt::print("{} submissions: java -jar jplag.jar -l cpp -bc {} {}\n", count,
             shell_quoted((to / "base-code").string()),
             shell_quoted((to / "submissions").string()));
  return 0;
}

const RegisterCommand export_command{
    {.usage = "export jplag DIR|ZIP... --out D",
     .details =
         "For JPlag, which finds similar submissions: D/submissions/ with a folder for each "
         "submission and the labs' files in it, and D/base-code/ with the starters that all "
         "students have. Submissions are found as in ./lab grade; links are not followed. JPlag "
         "itself is at https://github.com/jplag/JPlag; this prints the command.",
     .options = {{"--out D", "a new or empty directory"}},
     .run = export_class,
     .least_words = 2}};

}  // namespace
}  // namespace mc::grader
