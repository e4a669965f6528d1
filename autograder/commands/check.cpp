// check: judges one lab of a submission.

#include <cstdio>

#include "commands/command.hpp"
#include "commands/progress.hpp"
#include "commands/watch.hpp"
#include "judge/checkout/hints.hpp"
#include "judge/judging/judge_submission.hpp"
#include "judge/reports/progress_line.hpp"
#include "judge/submission/compile.hpp"
#include "judge/submission/diagnostics.hpp"
#include "judge/submission/intake.hpp"
#include "judge/submission/source.hpp"

namespace mc::grader {
namespace {

/// The same command, judging once; `task` in place of all tasks, unless it is empty.
Job without_watch(const Context& context, const Arguments& arguments, const std::string& task) {
  std::vector<std::string> words{(context.layout.bin / "lab").string(), "check"};
  for (const auto& [option, value] : arguments.options) {
    if (option == "watch") continue;
    words.push_back("--" + option + (value.empty() ? "" : '=' + value));
  }
  if (!task.empty()) words.push_back("--only=" + task);
  words.emplace_back("--");
  words.insert(words.end(), arguments.words.begin(), arguments.words.end());
  return job_of(std::move(words));
}

/// The files that a verdict on this lab depends on.
std::vector<fs::path> files_of(const Submission& submission, const Lab& lab) {
  std::vector<fs::path> files{submission.files.at(lab.name)};
  for (const std::string& name : lab.depends_on) {
    const auto file = submission.files.find(name);
    if (file != submission.files.end()) files.push_back(file->second);
  }
  return files;
}

int check(const Context& context, const Arguments& arguments) {
  const LabAndTask named = lab_and_task(context.labs, arguments.words);
  if (named.rest.size() > 1) throw WrongUsage();
  const Lab& lab = named.lab;
  const bool is_own = named.rest.empty();
  const fs::path directory = is_own ? context.layout.starter() : fs::path(named.rest[0]);
  const auto json = arguments.output("json");
  const Intake intake = take_in_one(context, directory);
  const Submission& submission = intake.entries[0].submission;
  // For a machine that reads results.json, a missing file is a grade of 0 points.
  if (!submission.files.contains(lab.name) && !json) {
    throw UsageError(
        fmt::format("{} has no {}{}", directory.string(), lab.file(), what_is_there(submission)));
  }
  if (arguments.has("watch")) {
    if (json) throw UsageError("--watch cannot be combined with --json");
    if (!fs::is_directory(directory)) throw UsageError("--watch takes a directory");
    // The task that the student works on is judged first, alone.
    const bool is_whole =
        is_own && named.task.empty() && !arguments.has("only") && !arguments.has("first");
    return watch({.files = files_of(submission, lab),
                  .jobs =
                      [&] {
                        std::vector<Job> jobs;
                        const auto known =
                            is_whole ? read_progress(context.layout, lab) : std::nullopt;
                        if (known && !known->next.empty()) {
                          jobs.push_back(without_watch(context, arguments, known->next));
                        }
                        jobs.push_back(without_watch(context, arguments, ""));
                        return jobs;
                      },
                  .subject = lab.file()});
  }
  const bool is_first_time = !fs::exists(context.layout.build / "programs");
  SubmissionOptions options;
  options.judge.seed = arguments.seed();
  options.judge.only = arguments.get("only").value_or(named.task);
  options.judge.first = arguments.has("first");
  options.judge.with_reference = arguments.has("with-reference");
  options.with_speed = false;
  const bool is_whole = options.judge.only.empty() && !options.judge.first;
  Verdict verdict = [&] {
    ProgressLine line("checking " + lab.name);
    options.progress = [&](double done, double all, const std::string& what) {
      line.show(100 * done, 100 * all, what);
    };
    return judge_submission(context, submission, {lab}, options);
  }();
  LabVerdict& judged = verdict.labs[0];
  const auto watched = watching_terminal();
  fmt::print("{}", watched ? report_open_first(judged, verdict, *watched)
                           : report_lab(judged, verdict, this_terminal()));
  if (is_own && judged.no_program.empty() && (is_whole || !watched)) {
    constexpr int often = 3;
    const auto [times, failing] = failures_in_a_row(context.layout, judged);
    if (times >= often && !hints_for(context.layout, lab, failing).empty()) {
      fmt::print("  Stuck on {0}? ./lab hint {0} shows a step towards it.\n", failing);
    }
  }
  if (judged.no_program.empty()) {
    const std::string note =
        missing_include({lab.file(), read_source(submission.files.at(lab.name)).text});
    if (!note.empty()) fmt::print("  {}\n", wrapped(note, this_terminal().width - 2, 2));
  }
  std::fflush(stdout);  // into a pipe, too: the next step takes a while
  // There is no grade, and no file that looks like one.
  if (!verdict.not_judged.empty()) throw MachineError(not_judged_line(verdict));
  // With --watch, the next verdict comes first; the reference's files are not the student's speed.
  if (judged.no_program.empty() && !watched && judged.on_reference.empty()) {
    {
      const ProgressLine line("timing " + lab.name);
      add_speed(context, submission, judged);
    }
    if (!judged.speed.empty()) fmt::print("\n{}", report_speed(judged));
  }
  if (json) write_text(*json, results_json(verdict));
  // Speeds up later runs; a first-time user should not wait for it.
  if (!is_first_time) precompile_headers(context.layout);
  if (is_own && is_whole && judged.on_reference.empty()) write_progress(context.layout, judged);
  return verdict.earned() == verdict.points() ? 0 : 1;
}

const RegisterCommand check_command{
    {.usage =
         "check LAB [TASK] [DIR] [--first] [--watch] [--seed S] [--json FILE] [--with-reference]",
     .about = "check one lab in starter/ (or DIR)",
     .details =
         "LAB is a number, a name or a folder: 1, variance, 1-variance. With a TASK, only its "
         "checks: ./lab check 1.3, or ./lab check variance 1.3, or --only 1.3.\n"
         "Exit status: 0 all points, 1 points are missing, 2 bad usage, 3 the machine lacks "
         "something.",
     .options = {{"--only TASK", "only the checks of this task"},
                 {"--first", "stop at the first task that fails"},
                 {"--watch",
                  "judge again after each save, the first unsolved task on top; Ctrl-C ends"},
                 {"--seed S", "repeat the run with that seed; every report names its seed"},
                 {"--json FILE", "also write Gradescope's results.json"},
                 {"--with-reference", "use the solutions of the labs that this one depends on",
                  "solutions"}},
     .run = check,
     .least_words = 1,
     .targets = target_of_lab<checks_target>}};

}  // namespace
}  // namespace mc::grader
