// grade: judges whole submissions.

#include <algorithm>
#include <memory>
#include <set>

#include "classes/batch.hpp"
#include "classes/page.hpp"
#include "classes/slurm.hpp"
#include "commands/command.hpp"
#include "judge/base/side_by_side.hpp"
#include "judge/judging/points.hpp"
#include "judge/pictures/plots.hpp"
#include "judge/reports/progress_line.hpp"
#include "judge/reports/report.hpp"
#include "judge/submission/compile.hpp"
#include "runner/text.hpp"

namespace mc::grader {
namespace {

/// The labs that --lab names; empty without --lab: those that were handed in.
std::vector<Lab> requested_labs(const Context& context, const Arguments& arguments) {
  const auto names = arguments.get("lab");
  if (!names) return {};
  std::set<int> numbers;
  for (const std::string_view name : text::split(*names, ',')) {
    numbers.insert(find_lab(context.labs, std::string(name)).number);
  }
  std::vector<Lab> labs = context.labs;
  std::erase_if(labs, [&](const Lab& lab) { return !numbers.contains(lab.number); });
  return labs;
}

bool is_below(const fs::path& file, const fs::path& directory) {
  const fs::path path = fs::weakly_canonical(fs::absolute(file).parent_path()) / "";
  const fs::path top = fs::weakly_canonical(directory) / "";
  const std::string name = path.string(), above = top.string();
  return name.starts_with(above);
}

/// A file of results in what is judged would be judged the next time.
void require_outside(const std::string& file, const std::vector<std::string>& places) {
  for (const std::string& place : places) {
    if (!fs::is_directory(place) || !is_below(file, place)) continue;
    throw UsageError(fmt::format("{} is inside {}, which is judged: write it elsewhere",
                                 sandbox::printable_line(file), sandbox::printable_line(place)));
  }
}

Intake intake_of(const Context& context, const Arguments& arguments) {
  const auto place = arguments.get("class");
  if (place && !arguments.words.empty()) {
    throw UsageError("name submissions, or --class and the directory of all, not both");
  }
  if (!place && arguments.words.empty()) throw WrongUsage();
  Intake intake = place ? take_in_class(context, *place) : take_in(context, arguments.words);
  for (const std::string& file : intake.left_out) fmt::print("left out: {}\n", file);
  if (place)
    fmt::print("{} submissions in {}\n", intake.entries.size(), sandbox::printable_line(*place));
  if (intake.entries.empty()) throw UsageError("there is no submission in " + *place);
  return intake;
}

/// Draws the plots of these labs, into a directory of the submission's name.
Pictures drawn(const Context& context, const Submission& submission, const std::vector<Lab>& labs,
               std::vector<std::string>* remarks) {
  Pictures pictures;
  for (const Lab& lab : labs) {
    if (!submission.files.contains(lab.name)) continue;
    const Plots plots = draw_plots(context.layout, lab, {submission}, submission.label);
    for (const fs::path& picture : plots.pictures) {
      if (picture.extension() == ".svg") pictures[lab.name].push_back(picture);
    }
    if (remarks == nullptr) continue;
    remarks->insert(remarks->end(), plots.remarks.begin(), plots.remarks.end());
  }
  return pictures;
}

void write_pages(const Context& context, const fs::path& directory,
                 const std::vector<Verdict>& verdicts, const std::vector<IntakeEntry>& entries,
                 bool with_pictures) {
  ProgressLine line("drawing");
  write_class_pages(directory, verdicts, [&](std::size_t i) {
    line.show(static_cast<double>(i), static_cast<double>(verdicts.size()), "pages");
    const auto entry = std::ranges::find_if(entries, [&](const IntakeEntry& one) {
      return one.submission.label == verdicts[i].submission;
    });
    if (!with_pictures || entry == entries.end() || !verdicts[i].not_judged.empty()) {
      return Pictures();
    }
    std::vector<Lab> labs;
    for (const LabVerdict& lab : verdicts[i].labs) labs.push_back(lab.lab);
    return drawn(context, entry->submission, labs, nullptr);
  });
  fmt::print("pages: {}\n", sandbox::printable_line((directory / "index.html").string()));
}

/// The full report on one submission.
Verdict grade_one(const Context& context, const IntakeEntry& entry, const BatchOptions& options) {
  const Submission& submission = entry.submission;
  const auto labs = labs_of(context, submission, options.requested);
  Verdict verdict = [&] {
    ProgressLine line("grading " + submission.label);
    SubmissionOptions judging = options.judging;
    judging.progress = [&](double done, double all, const std::string& what) {
      line.show(100 * done, 100 * all, fmt::format("{}, {}", submission.label, what));
    };
    return judge_entry(context, entry, labs, judging);
  }();
  for (const LabVerdict& lab : verdict.labs) {
    fmt::print("{}\n", report_lab(lab, verdict, this_terminal()));
  }
  if (labs.size() > 1 || !verdict.unreadable.empty()) fmt::print("{}", report_summary({verdict}));
  const std::string reason = reason_of(verdict);
  if (!reason.empty() && verdict.unreadable.empty()) fmt::print("{}\n", reason);
  if (!verdict.absent.empty() && options.requested.empty() && verdict.unreadable.empty()) {
    fmt::print("not handed in: {}\n", fmt::join(verdict.absent, ", "));
  }
  return verdict;
}

/// Judges what is not known yet; throws MachineError after all results are written.
BatchOutcome grade_many(const Context& context, const std::vector<IntakeEntry>& entries,
                        const VerdictStore* store, const BatchOptions& options) {
  BatchOutcome outcome = run_batch(context, entries, store, options);
  Verdict here;
  here.jail_complete = sandbox::jail_is_complete();
  here.reads_confined = sandbox::places_are_enforced();
  fmt::print("{}", jail_warning(here));
  fmt::print("{} submissions: {} judged", entries.size(), outcome.judged);
  if (outcome.known > 0) fmt::print(", {} already judged", outcome.known);
  if (outcome.unreadable > 0) fmt::print(", {} unreadable", outcome.unreadable);
  if (outcome.not_judged > 0) fmt::print(", {} not judged", outcome.not_judged);
  fmt::print("; seed {}\n", options.judging.judge.seed);
  return outcome;
}

void require_judged(const BatchOutcome& outcome, std::size_t all, bool can_resume) {
  const std::string next = can_resume ? "; after fixing that, continue with --resume" : "";
  if (!outcome.stopped.empty()) {
    throw MachineError(
        fmt::format("the machine fails for a known program, too ({}): the rest was not "
                    "tried{}",
                    outcome.stopped, next));
  }
  if (outcome.not_judged > 0) {
    throw MachineError(
        fmt::format("not judged: {} of {} submissions{}", outcome.not_judged, all, next));
  }
}

/// The same command, for the tasks of a job array.
std::vector<std::string> task_words(const Arguments& arguments, std::uint64_t seed) {
  std::vector<std::string> words{"grade", "--seed", std::to_string(seed), "-j", "1"};
  for (const auto& [option, value] : arguments.options) {
    if (option == "seed" || option == "jobs" || option == "resume") continue;
    words.push_back("--" + option + (value.empty() ? "" : '=' + value));
  }
  words.emplace_back("--");
  words.insert(words.end(), arguments.words.begin(), arguments.words.end());
  return words;
}

void check_options(const Arguments& arguments) {
  const auto html = arguments.output("html"), csv = arguments.output("csv");
  std::vector<std::string> places = arguments.words;
  if (const auto place = arguments.get("class")) places.push_back(*place);
  for (const auto& file : {arguments.output("json"), csv, html}) {
    if (file) require_outside(*file, places);
  }
  if (html && fs::exists(*html) && !fs::is_directory(*html)) {
    throw UsageError(
        fmt::format("--html takes a directory, but {} is not one", sandbox::printable_line(*html)));
  }
  if (arguments.has("json") && (arguments.words.size() != 1 || csv || html)) {
    throw UsageError("--json takes one DIR and no --csv or --html: Gradescope reads that file");
  }
  if (arguments.has("resume") && !csv) {
    throw UsageError("--resume needs the --csv of the run to continue");
  }
  if (arguments.has("slurm") && (!csv || html)) {
    throw UsageError("--slurm needs --csv FILE, and no --html: use that later, with --resume");
  }
}

int grade(const Context& context, const Arguments& arguments) {
  check_options(arguments);
  require_known_points(context.layout, context.labs);
  const auto csv = arguments.get("csv"), html = arguments.get("html"), json = arguments.get("json");
  const bool is_task = arguments.has("slurm") && slurm_task();
  BatchOptions options;
  options.requested = requested_labs(context, arguments);
  options.workers = static_cast<unsigned>(
      std::clamp<std::uint64_t>(arguments.number("jobs").value_or(cores()), 1, 512));
  JudgeOptions& judge = options.judging.judge;
  judge.workers = options.workers;
  judge.with_reference = arguments.has("with-reference");
  sweep_scratch(context.layout);
  const Intake intake = intake_of(context, arguments);
  std::optional<VerdictStore> store;
  if (csv) {
    store.emplace(*csv, is_task                   ? StoreMode::task
                        : arguments.has("resume") ? StoreMode::resume
                                                  : StoreMode::anew);
  }
  const auto given = arguments.number("seed");
  if (store && store->seed() && given && *given != *store->seed()) {
    throw UsageError(fmt::format("{} was started with seed {}", *csv, *store->seed()));
  }
  judge.seed = store && store->seed() ? *store->seed() : arguments.seed();
  precompile_headers(context.layout);

  if (is_task) {
    const std::size_t mine = *slurm_task();
    if (mine >= intake.entries.size()) throw UsageError("there is no submission for this task");
    const BatchOutcome outcome = grade_many(context, {intake.entries[mine]}, &*store, options);
    require_judged(outcome, 1, true);
    return 0;
  }
  if (arguments.has("slurm")) {
    const std::size_t count = intake.entries.size();
    const std::string job = submit_tasks(context, *store, task_words(arguments, judge.seed), count);
    fmt::print(
        "job {}: {} tasks, seed {}; when squeue lists none of them, the same with --resume and "
        "without --slurm\ncollects their verdicts, and judges here what they did not\n",
        job, count, judge.seed);
    return 0;
  }
  if (store) require_finished_tasks(*store);

  const bool is_one = intake.entries.size() == 1 && !arguments.has("class") && !store;
  BatchOutcome outcome;
  if (is_one) {
    const IntakeEntry& entry = intake.entries[0];
    if (!json && !entry.unreadable.empty()) throw UsageError(entry.unreadable);
    outcome.verdicts.push_back(grade_one(context, entry, options));
    const Verdict& verdict = outcome.verdicts[0];
    if (!json && verdict.labs.empty() && verdict.not_judged.empty()) {
      throw UsageError(fmt::format("{} contains no lab files ({} …)", entry.submission.label,
                                   context.labs.empty() ? "" : context.labs[0].file()));
    }
    // There is no grade, and no file that looks like one.
    if (!verdict.not_judged.empty()) throw MachineError("not judged: " + verdict.not_judged);
    if (json) write_text(*json, results_json(verdict));
    if (!html && !arguments.has("no-plots")) {
      std::vector<std::string> remarks;
      const auto pictures = drawn(context, entry.submission,
                                  labs_of(context, entry.submission, options.requested), &remarks);
      for (const std::string& remark : remarks) fmt::print("{}\n", sandbox::printable(remark));
      for (const auto& [lab, files] : pictures) {
        for (const fs::path& file : files) fmt::print("{}\n", file.string());
      }
    }
  } else {
    outcome = grade_many(context, intake.entries, store ? &*store : nullptr, options);
  }
  if (csv) {
    const auto columns = columns_for(context, intake.entries, options.requested);
    write_text(*csv, grade_table(columns, outcome.verdicts));
  }
  if (html) {
    write_pages(context, *html, outcome.verdicts, intake.entries, !arguments.has("no-plots"));
  }
  require_judged(outcome, intake.entries.size(), csv.has_value());
  return 0;
}

const RegisterCommand grade_command{
    {.usage = "grade DIR|ZIP... | --class DIR|ZIP [--lab LAB] [--csv FILE [--resume]] "
              "[--html DIR] ...",
     .about = "grade whole submissions",
     .details =
         "Each DIR or ZIP is one submission: ./lab grade solutions, ./lab grade class/*. With "
         "--class, each entry of one directory or archive is one student. Grades every lab that "
         "has "
         "a file: at the top of a submission, in starter/, or anywhere below. One submission gets "
         "a "
         "report of each check, and plots; several get one line each.\n"
         "Exit status: 0 all are judged, 2 bad usage, 3 the machine failed: some submissions are "
         "not judged and have no points.",
     .options =
         {{"--class DIR|ZIP",
           "judge a class: every directory and archive in it is one student, whatever it is "
           "called, and the files of an export of Canvas, Moodle or Blackboard; what belongs to "
           "no student is listed"},
          {"--lab LAB,…", "grade only these labs (--lab 1,2); a missing file earns 0 points"},
          {"--csv FILE",
           "write a table with a row for each submission; each full verdict goes to FILE-verdicts/ "
           "as soon as it is complete"},
          {"--resume",
           "continue a run with the same FILE and its seed; changed submissions and those "
           "that were not judged are judged again"},
          {"--with-reference", "use the solutions of the labs that a lab depends on", "solutions"},
          {"--html DIR",
           "write DIR/index.html, a table of submissions and tasks, and a page for each submission "
           "with its report and its plots"},
          {"--json FILE", "write Gradescope's results.json (one DIR)"},
          {"--seed S", "use this seed"},
          {"--jobs N, -j N",
           "run N jobs at once: submissions, or checks of a single one (all cores)"},
          {"--slurm", "with --csv: submit a cluster task per submission; --resume collects them"},
          {"--no-plots", "no plots"}},
     .run = grade,
     .for_instructors = true,
     .targets = [](const Context&, const Arguments&) {
       return std::vector<std::string>{"judge_all"};
     }}};

}  // namespace
}  // namespace mc::grader
