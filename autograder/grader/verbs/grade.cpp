// grade: whole submissions, judged.

#include <algorithm>
#include <filesystem>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "grader/context/errors.hpp"
#include "grader/context/text_file.hpp"
#include "grader/judging/judge_submission.hpp"
#include "grader/reports/progress_line.hpp"
#include "grader/reports/report.hpp"
#include "grader/submission/compile.hpp"
#include "grader/submission/intake.hpp"
#include "grader/submission/scratch.hpp"
#include "grader/verbs/judging_options.hpp"
#include "grader/verbs/verb.hpp"
#include "runner/text.hpp"
#include "sandbox/printable.hpp"
#include "sandbox/process.hpp"

namespace mc::grader {
namespace {

namespace fs = std::filesystem;

/// The labs that --lab names, by number; empty where it is not there: those that were handed in.
std::vector<Lab> labs_asked_for(const Context& context, const Arguments& arguments) {
  std::vector<Lab> labs;
  const auto names = arguments.get("lab");
  if (!names) return labs;
  for (const std::string_view name : text::split(*names, ',')) {
    const Lab& lab = find_lab(context.labs, std::string(name));
    const auto same = [&](auto& one) { return one.number == lab.number; };
    if (std::none_of(labs.begin(), labs.end(), same)) labs.push_back(lab);
  }
  std::sort(labs.begin(), labs.end(), [](auto& a, auto& b) { return a.number < b.number; });
  return labs;
}

std::vector<Lab> labs_of(const Context& context, const Submission& submission,
                         const std::vector<Lab>& asked_for) {
  if (!asked_for.empty()) return asked_for;
  std::vector<Lab> present;
  for (const Lab& lab : context.labs) {
    if (submission.files.contains(lab.name)) present.push_back(lab);
  }
  return present;
}

/// Draws with the program that can: its pictures are listed.
void show_plots(const Context& context, const Submission& submission,
                const std::vector<Lab>& labs) {
  const std::string program = (context.layout.build / "bin" / "pictures").string();
  for (const Lab& lab : labs) {
    const auto file = submission.files.find(lab.name);
    if (file == submission.files.end()) continue;
    const auto drawn = sandbox::run_process(
        {program, "plot", lab.name, file->second.parent_path().string(), "--alone"});
    fmt::print("{}", drawn.output);
    if (!drawn.succeeded()) fmt::print("{}", sandbox::printable(drawn.errors));
  }
}

Verdict judge_handed(const Context& context, const Handed& handed, const std::vector<Lab>& labs,
                     const SubmissionOptions& options) {
  if (handed.unreadable.empty()) return judge_submission(context, handed.submission, labs, options);
  Verdict verdict;
  verdict.submission = handed.submission.label;
  verdict.seed = options.judge.seed;
  verdict.version = context.layout.version;
  verdict.jail_complete = sandbox::jail_is_complete();
  verdict.not_judged = "unreadable: " + handed.unreadable;
  return verdict;
}

int grade(const Context& context, const Arguments& arguments) {
  if (arguments.words.empty())
    throw UsageError("usage: ./lab grade DIR|ZIP... (try: ./lab grade solutions)");
  const auto json = arguments.get("json"), csv = arguments.get("csv");
  require_writable(json);
  require_writable(csv);
  if (json && arguments.words.size() > 1) {
    throw UsageError("--json takes one DIR; for several there is --csv");
  }
  const std::vector<Lab> asked_for = labs_asked_for(context, arguments);
  SubmissionOptions options;
  options.judge.seed = seed_of(arguments);
  options.judge.workers =
      static_cast<unsigned>(std::clamp<std::uint64_t>(arguments.number("jobs").value_or(2), 1, 64));
  sweep_scratch(context.layout);
  const Intake intake = take_in(context, arguments.words, json ? Meaning::one : Meaning::many);
  precompile_headers(context.layout);
  const bool single = intake.handed.size() == 1;
  if (single && !intake.handed[0].unreadable.empty()) {
    throw UsageError(intake.handed[0].unreadable);
  }
  std::vector<Verdict> verdicts;
  for (const Handed& handed : intake.handed) {
    const Submission& submission = handed.submission;
    const auto labs = labs_of(context, submission, asked_for);
    if (labs.empty() && single && !json && !csv) {
      throw UsageError(fmt::format("{} has no file of any lab ({} …)", submission.label,
                                   context.labs.empty() ? "" : context.labs[0].file()));
    }
    {
      ProgressLine line("grading " + submission.label);
      options.progress = [&](double done, double all, const std::string& what) {
        line.show(100 * done, 100 * all, fmt::format("{}, {}", submission.label, what));
      };
      verdicts.push_back(judge_handed(context, handed, labs, options));
    }
    const Verdict& verdict = verdicts.back();
    if (!single) {
      fmt::print("{}", report_summary({verdict}));
      continue;
    }
    for (const LabVerdict& lab : verdict.labs) {
      fmt::print("{}\n", report_lab(lab, verdict, this_terminal()));
    }
    if (labs.size() > 1) fmt::print("{}", report_summary(verdicts));
    if (!verdict.absent.empty()) {
      fmt::print("not handed in: {}\n", fmt::join(verdict.absent, ", "));
    }
    if (!arguments.has("no-plots")) show_plots(context, submission, labs);
  }
  if (!single) fmt::print("{}", jail_warning(verdicts[0]));
  if (json) write_text(*json, report_json(verdicts[0]));
  if (csv) write_text(*csv, report_csv(verdicts));
  return 0;
}

const RegisterVerb grade_verb{
    {"grade",
     "grade DIR|ZIP... [--lab LAB] [--json FILE] [--csv FILE] [--seed S] [-j N] [--no-plots]",
     {"lab=,", "json=", "csv=", "seed=", "jobs=j", "no-plots"},
     "Every lab that DIR has a file of: at its top, in starter/, or wherever it is below. One DIR "
     "is\n"
     "reported check by check and its plots are drawn; of several, a line each. A directory or zip "
     "of\n"
     "several people's work, as Gradescope, Canvas and Moodle export it, means each of them.\n"
     "  --lab LAB     that lab, whatever was handed in: no file is 0 points (several: --lab 1,2)\n"
     "  --json FILE   Gradescope's results.json (one DIR)\n"
     "  --csv FILE    a row for each DIR\n"
     "  --seed S      the same seed again\n"
     "  -j N          so many checks at the same time (2)\n"
     "  --no-plots    no plots\n",
     grade}};

}  // namespace
}  // namespace mc::grader
