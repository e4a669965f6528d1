// run: runs one experiment by hand.

#include <cstdlib>

#include "commands/command.hpp"
#include "judge/reports/progress_line.hpp"
#include "judge/reports/report.hpp"
#include "judge/submission/build.hpp"
#include "judge/submission/diagnostics.hpp"
#include "judge/submission/from_source.hpp"
#include "judge/submission/intake.hpp"
#include "judge/submission/source.hpp"

namespace mc::grader {
namespace {

/// Builds the program to run, for judging or for a kind of debugging; if that fails, prints the
/// reason and returns an empty path.
std::string program_of(const Context& context, const Lab& lab, const Submission& submission,
                       const std::optional<BuildKind>& kind) {
  if (!kind) {
    const BuildResult built = build_program(context.layout, lab, submission);
    if (!built.program) fmt::print("{}\n", built.failure);
    return built.program ? built.program->path : "";
  }
  const ProgramByHand built = [&] {
    const ProgressLine line(fmt::format("building {} ({})", lab.name, kind->name));
    return build_by_hand(context.layout, lab, submission, *kind);
  }();
  fmt::print(stderr, "{}{}", built.failure,
             built.failure.empty() ? built.path.string() + "\n" : std::string());
  const std::string note =
      missing_include({lab.file(), read_source(submission.files.at(lab.name)).text});
  if (built.failure.empty() && !note.empty()) fmt::print(stderr, "{}\n", note);
  setenv("UBSAN_OPTIONS", "print_stacktrace=1:halt_on_error=1", 0);
  return built.path.string();
}

std::optional<BuildKind> kind_of(const Arguments& arguments) {
  if (arguments.has("sanitize")) return for_sanitizers();
  if (arguments.has("debug")) return for_debugger();
  return {};
}

int run(const Context& context, const Arguments& arguments) {
  const Lab& lab = find_lab(context.labs, arguments.words[0]);
  const fs::path directory = arguments.get("dir").value_or(context.layout.starter().string());
  const Intake intake = take_in_one(context, directory);
  const Submission& submission = intake.entries[0].submission;
  const std::string program = program_of(context, lab, submission, kind_of(arguments));
  if (program.empty()) return 1;
  if (arguments.has("debug")) return 0;  // for a debugger, which starts it
  if (arguments.words.size() == 1) {
    const std::size_t width = this_terminal().width;
    fmt::print(
        "The experiments of {}. Run one with\n\n  ./lab run {} EXPERIMENT --NAME VALUE "
        "...\n\n{}\n\n",
        lab.title(), lab.name,
        wrapped("or with the values alone, in this order. Numbers are written 0.5, lists 1,2,4 "
                "or @FILE, structs 3:0.5:2.",
                width, 0));
    execute({program, "--list", std::to_string(width)});
  }
  std::vector<std::string> command = arguments.words_after(1);
  command.insert(command.begin(), program);
  execute(std::move(command));
}

const RegisterCommand run_command{
    {.usage = "run LAB [--dir DIR] [--sanitize | --debug] [EXPERIMENT ARGUMENT...]",
     .about = "run one experiment by hand and print its numbers",
     .details = "For example: ./lab run variance mean 1,2,4. Without EXPERIMENT: list the "
                "experiments of the lab. Numbers are written 0.5, lists 1,2,4, structs 3:0.5:2. "
                "There is no sandbox here: it is your own program, on your own machine.",
     .options = {{"--dir DIR", "use the files of DIR instead of starter/"},
                 {"--sanitize",
                  "build with the address and undefined-behavior sanitizers; prints the path of "
                  "the program"},
                 {"--debug", "only build the program for a debugger, and print its path"}},
     .run = run,
     .least_words = 1,
     .words_before_verbatim = 2,
     .targets = [](const Context& context, const Arguments& arguments) {
       std::vector<std::string> targets = target_of_lab<experiments_target>(context, arguments);
       targets.emplace_back("runner");
       return targets;
     }}};

}  // namespace
}  // namespace mc::grader
