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
#include "grader/submission/scratch.hpp"
#include "grader/verbs/judging_options.hpp"
#include "grader/verbs/verb.hpp"
#include "sandbox/printable.hpp"
#include "sandbox/process.hpp"

namespace mc::grader {
namespace {

namespace fs = std::filesystem;

std::vector<Lab> labs_in(const Context& context, const Submission& submission) {
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
    const auto drawn =
        sandbox::run_process({program, "plot", lab.name, submission.path.string(), "--alone"});
    fmt::print("{}", drawn.output);
    if (!drawn.succeeded()) fmt::print("{}", sandbox::printable(drawn.errors));
  }
}

int grade(const Context& context, const Arguments& arguments) {
  if (arguments.words.empty())
    throw UsageError("usage: ./lab grade DIR... (try: ./lab grade solutions)");
  const auto json = arguments.get("json"), csv = arguments.get("csv");
  require_writable(json);
  require_writable(csv);
  if (json && arguments.words.size() > 1) {
    throw UsageError("--json takes one DIR; for several there is --csv");
  }
  SubmissionOptions options;
  options.judge.seed = seed_of(arguments);
  options.judge.workers =
      static_cast<unsigned>(std::clamp<std::uint64_t>(arguments.number("jobs").value_or(2), 1, 64));
  std::vector<Submission> submissions;
  for (const std::string& word : arguments.words) {
    submissions.push_back(open_submission(context.labs, word));
  }
  sweep_scratch(context.layout);
  precompile_headers(context.layout);
  const bool single = submissions.size() == 1;
  std::vector<Verdict> verdicts;
  for (const Submission& submission : submissions) {
    const auto labs = labs_in(context, submission);
    if (labs.empty() && single && !json && !csv) {
      throw UsageError(fmt::format("{} has no file of any lab ({} …)", submission.label,
                                   context.labs.empty() ? "" : context.labs[0].file()));
    }
    {
      ProgressLine line("grading " + submission.label);
      options.progress = [&](double done, double all, const std::string& what) {
        line.show(100 * done, 100 * all, fmt::format("{}, {}", submission.label, what));
      };
      verdicts.push_back(judge_submission(context, submission, labs, options));
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
     "grade DIR... [--json FILE] [--csv FILE] [--seed S] [-j N] [--no-plots]",
     {"json=", "csv=", "seed=", "jobs=j", "no-plots"},
     "Every lab that DIR has a file of. One DIR is reported check by check and its plots are "
     "drawn;\n"
     "of several, a line each.\n"
     "  --json FILE   Gradescope's results.json (one DIR)\n"
     "  --csv FILE    a row for each DIR\n"
     "  --seed S      the same seed again\n"
     "  -j N          so many checks at the same time (2)\n"
     "  --no-plots    no plots\n",
     grade}};

}  // namespace
}  // namespace mc::grader
