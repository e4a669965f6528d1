// grade: judges whole submissions.

#include <algorithm>
#include <map>
#include <memory>
#include <set>

#include "grader/commands/command.hpp"
#include "grader/commands/manifest.hpp"
#include "grader/gradebook/batch.hpp"
#include "grader/gradebook/class_page.hpp"
#include "grader/gradebook/corrections.hpp"
#include "grader/gradebook/roster.hpp"
#include "grader/gradebook/slurm.hpp"
#include "grader/judging/points.hpp"
#include "grader/reports/progress_line.hpp"
#include "grader/reports/report.hpp"
#include "grader/submission/compile.hpp"
#include "grader/submission/hours.hpp"
#include "runner/text.hpp"
#include "sandbox/process.hpp"

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

/// Draws with the program that can, and prints the names of the pictures.
void show_plots(const Context& context, const Submission& submission,
                const std::vector<Lab>& labs) {
  const std::string program = context.layout.course().string();
  for (const Lab& lab : labs) {
    const auto file = submission.files.find(lab.name);
    if (file == submission.files.end()) continue;
    const auto drawn = sandbox::run_process(
        {program, "plot", lab.name, file->second.parent_path().string(), "--alone"});
    fmt::print("{}", drawn.output);
    if (!drawn.succeeded()) fmt::print("{}", sandbox::printable(drawn.errors));
  }
}

/// One shard of the class: "2/3" has every third submission, beginning with the second.
std::vector<IntakeEntry> shard_of(std::vector<IntakeEntry> entries,
                                  const std::optional<std::string>& shard) {
  if (!shard) return entries;
  std::uint64_t which = 0, count = 0;
  try {
    const auto parts = text::split(*shard, '/');
    if (parts.size() == 2) {
      text::parse(parts[0], which);
      text::parse(parts[1], count);
    }
  } catch (const std::invalid_argument&) {  // reported below
  }
  if (which == 0 || which > count) {
    throw UsageError(fmt::format("--shard takes k/n with 1 <= k <= n, not '{}'",
                                 sandbox::printable_line(*shard)));
  }
  std::vector<IntakeEntry> mine;
  for (std::size_t i = which - 1; i < entries.size(); i += count) {
    mine.push_back(std::move(entries[i]));
  }
  return mine;
}

/// The seed of the run to resume; for a new run, the given one or a fresh one.
std::uint64_t seed_for(const Arguments& arguments, const std::optional<std::string>& csv) {
  const auto given = arguments.number("seed");
  if (!csv) {
    if (arguments.has("resume"))
      throw UsageError("--resume needs the --csv of the run to continue");
    return arguments.seed();
  }
  const BookState state = read_book_state(*csv);
  if (!arguments.has("resume")) {
    if (state.exists && !state.finished && state.verdicts > 0) {
      throw UsageError(
          fmt::format("{} has {} verdicts of an unfinished run: --resume continues "
                      "it; to start over, remove it",
                      verdict_directory(*csv).string(), state.verdicts));
    }
    return arguments.seed();
  }
  if (state.exists && given && *given != state.seed) {
    throw UsageError(fmt::format("{} was started with seed {}", *csv, state.seed));
  }
  return state.exists ? state.seed : arguments.seed();
}

/// The output of a run: its table and verdicts, if requested, and its pages.
class Records {
 public:
  Records(const Context& context, const Arguments& arguments, const std::vector<IntakeEntry>& all,
          const BatchOptions& options, const std::vector<IntakeEntry>& mine)
      : context_(context), mine_(mine), csv_(arguments.get("csv")), html_(arguments.get("html")) {
    if (html_) fs::create_directories(*html_);
    if (html_ && !csv_) {  // pages are made from a table in any case
      scratch_ = std::make_unique<ScratchDirectory>(context.layout);
      csv_ = (scratch_->path() / "grades.csv").string();
    }
    if (!csv_) return;
    std::vector<std::string> ids;
    for (const IntakeEntry& one : mine) ids.push_back(one.submission.label);
    // From all submissions, so that the tables of several shards have the same columns.
    const bool has_people =
        arguments.has("roster") || std::ranges::any_of(all, [](const IntakeEntry& one) {
          const Delivery& delivery = one.submission.delivery;
          return delivery.late || !delivery.submitted.empty();
        });
    book_.emplace(Book::Setup{*csv_, columns_for(context, all, options.requested),
                              has_people ? People::shown : People::hidden, std::move(ids),
                              options.judging.judge.seed, context.layout.version,
                              arguments.has("resume")});
  }

  Book* book() { return book_ ? &*book_ : nullptr; }

  void finish(bool whole) {
    if (book_) book_->finish(whole);
    if (!csv_) return;
    const Table corrected = read_corrected_table(*csv_, context_.labs);
    write_text(*csv_, table_text(corrected));
    if (!html_) return;
    write_class_pages(*html_, context_, corrected, mine_);
    fmt::print("pages: {}\n", sandbox::printable_line((fs::path(*html_) / "index.html").string()));
  }

 private:
  const Context& context_;
  const std::vector<IntakeEntry>& mine_;
  std::optional<std::string> csv_, html_;
  std::unique_ptr<ScratchDirectory> scratch_;
  std::optional<Book> book_;
};

/// The full report on one submission.
int grade_one(const Context& context, const IntakeEntry& entry, Records& records,
              const Arguments& arguments, const std::vector<Lab>& requested,
              SubmissionOptions options) {
  Book* const book = records.book();
  const Submission& submission = entry.submission;
  const auto json = arguments.get("json");
  const auto labs = labs_of(context, submission, requested);
  if (!entry.unreadable.empty() && book == nullptr && !json) throw UsageError(entry.unreadable);
  if (labs.empty() && book == nullptr && !json && entry.unreadable.empty()) {
    throw UsageError(fmt::format("{} contains no lab files ({} …)", submission.label,
                                 context.labs.empty() ? "" : context.labs[0].file()));
  }
  const Verdict verdict = [&] {
    ProgressLine line("grading " + submission.label);
    options.progress = [&](double done, double all, const std::string& what) {
      line.show(100 * done, 100 * all, fmt::format("{}, {}", submission.label, what));
    };
    return judge_entry(context, entry, labs, options);
  }();
  if (book != nullptr) {
    book->begin();
    book->add(verdict);
    records.finish(true);
  }
  for (const LabVerdict& lab : verdict.labs) {
    fmt::print("{}\n", report_lab(lab, verdict, this_terminal()));
  }
  if (labs.size() > 1 || !verdict.unreadable.empty()) fmt::print("{}", report_summary({verdict}));
  if (!verdict.absent.empty() && requested.empty() && verdict.unreadable.empty()) {
    fmt::print("not handed in: {}\n", fmt::join(verdict.absent, ", "));
  }
  // There is no grade, and no file that looks like one.
  if (!verdict.not_judged.empty()) throw MachineError("not judged: " + verdict.not_judged);
  if (json) {
    write_text(*json, report_json(verdict, {arguments.has("leaderboard"),
                                            arguments.visibility().value_or("visible")}));
  }
  if (!arguments.has("no-plots")) show_plots(context, submission, labs);
  return 0;
}

int grade_many(const Context& context, const std::vector<IntakeEntry>& entries, Records& records,
               bool can_resume, const BatchOptions& options) {
  const BatchOutcome outcome = run_batch(context, entries, records.book(), options);
  records.finish(outcome.stopped.empty() && outcome.not_judged == 0);
  Verdict here;
  here.jail_complete = sandbox::jail_is_complete();
  here.reads_confined = sandbox::places_are_enforced();
  fmt::print("{}", jail_warning(here));
  fmt::print("{} submissions: {} judged", entries.size(), outcome.judged);
  if (outcome.known > 0) fmt::print(", {} already judged", outcome.known);
  if (outcome.unreadable > 0) fmt::print(", {} unreadable", outcome.unreadable);
  if (outcome.not_judged > 0) fmt::print(", {} not judged", outcome.not_judged);
  fmt::print("; seed {}\n", options.judging.judge.seed);
  const std::string next = can_resume ? "; after fixing that, continue with --resume" : "";
  if (!outcome.stopped.empty()) {
    throw MachineError(
        fmt::format("the machine fails for a known program, too ({}): the rest was not "
                    "tried{}",
                    outcome.stopped, next));
  }
  if (outcome.not_judged > 0) {
    throw MachineError(fmt::format("not judged: {} of {} submissions{}", outcome.not_judged,
                                   entries.size(), next));
  }
  return 0;
}

/// Submits one cluster task per submission; --resume gathers the table.
int grade_on_slurm(const Context& context, const Arguments& arguments, std::size_t count,
                   Records& records, std::uint64_t seed) {
  SlurmTasks tasks;
  tasks.csv = *arguments.get("csv");
  tasks.count = count;
  tasks.seed = seed;
  tasks.is_resumed = arguments.has("resume");
  for (const char* option : {"lab", "roster", "speed", "with-reference"}) {
    const auto value = arguments.get(option);
    if (value) tasks.options.push_back(std::string("--") + option);
    if (value && !value->empty()) tasks.options.push_back(*value);
  }
  tasks.words = arguments.words;
  if (!tasks.is_resumed) records.book()->begin();
  const std::string job = submit_tasks(context, tasks);
  fmt::print(
      "job {}: {} tasks, seed {}; when squeue lists none of them, the same with --resume and "
      "without --slurm\ncollects their verdicts, and judges here what they did not\n",
      job, count, seed);
  return 0;
}

void check_slurm(const Arguments& arguments) {
  if (!arguments.has("slurm")) return;
  if (!arguments.has("csv")) throw UsageError("--slurm needs --csv FILE");
  for (const char* other : {"json", "html", "shard"}) {
    if (arguments.has(other)) {
      throw UsageError(
          fmt::format("--slurm cannot be combined with --{}: use it later, with --resume", other));
    }
  }
}

/// Gives the submissions the ids of the roster; prints who is only on the roster or not on it.
void apply_roster(const fs::path& file, std::vector<IntakeEntry>& entries) {
  const Roster roster = read_roster(file);
  const RosterReport report = match_roster(roster, entries);
  fmt::print("roster: {} students, {} without a submission\n", roster.people.size(),
             report.without_submission.size());
  const auto list = [](const char* what, const std::vector<std::string>& ids) {
    if (!ids.empty()) fmt::print("{}: {}\n", what, fmt::join(ids, ", "));
  };
  list("without a submission", report.without_submission);
  list("not on the roster", report.not_on_roster);
}

/// Prints which handouts and zips of ./lab submit have another version: their students saw other
/// checks.
void report_other_versions(const Context& context, const std::vector<IntakeEntry>& entries) {
  std::map<std::string, std::set<std::string>> ids;  // by version
  for (const IntakeEntry& entry : entries) {
    for (const auto& [lab, file] : entry.submission.files) {
      std::string version = read_manifest(file.parent_path()).version;
      if (version.empty()) version = read_manifest(file.parent_path().parent_path()).version;
      if (!version.empty() && version != context.layout.version) {
        ids[version].insert(entry.submission.label);
      }
    }
  }
  for (const auto& [version, who] : ids) {
    fmt::print("handout of version {}, judged by {}: {}\n", sandbox::printable_line(version),
               context.layout.version, fmt::join(who, ", "));
  }
}

int grade(const Context& context, const Arguments& arguments) {
  const auto json = arguments.output("json"), csv = arguments.output("csv"),
             html = arguments.output("html");
  if (html && fs::exists(*html) && !fs::is_directory(*html)) {
    throw UsageError(
        fmt::format("--html takes a directory, but {} is not one", sandbox::printable_line(*html)));
  }
  if (json && arguments.words.size() > 1) {
    throw UsageError("--json takes one DIR; for several there is --csv");
  }
  if (arguments.has("leaderboard") && !json) throw UsageError("--leaderboard needs --json FILE");
  if (arguments.visibility() && !json) throw UsageError("--visibility needs --json FILE");
  check_slurm(arguments);
  require_known_points(context.layout, context.labs);
  BatchOptions options;
  options.requested = requested_labs(context, arguments);
  options.workers = static_cast<unsigned>(
      std::clamp<std::uint64_t>(arguments.number("jobs").value_or(cores()), 1, 512));
  options.with_speed = arguments.has("speed");
  options.judging.judge.seed = seed_for(arguments, csv);
  options.judging.judge.workers = options.workers;
  options.judging.judge.with_reference = arguments.has("with-reference");
  sweep_scratch(context.layout);
  Intake intake = take_in(context, arguments.words, json ? Meaning::one : Meaning::many);
  if (!json && (arguments.words.size() > 1 || intake.entries.size() > 1)) {
    fmt::print("{} submissions: {}\n", intake.entries.size(),
               intake.each_word_is_one ? "one in each of these directories or zip files"
                                       : "one in each directory, zip file or name in these");
  }
  for (IntakeEntry& one : intake.entries) read_hours(context.labs, one.submission);
  if (const auto roster = arguments.get("roster")) apply_roster(*roster, intake.entries);
  report_other_versions(context, intake.entries);
  if (arguments.has("resume")) gather_tasks(*csv);
  const bool single =
      intake.entries.size() == 1 && !arguments.has("shard") && !arguments.has("roster");
  const std::vector<IntakeEntry> mine = shard_of(intake.entries, arguments.get("shard"));
  Records records(context, arguments, intake.entries, options, mine);
  precompile_headers(context.layout);
  if (arguments.has("slurm")) {
    return grade_on_slurm(context, arguments, mine.size(), records, options.judging.judge.seed);
  }
  if (single) {
    return grade_one(context, mine[0], records, arguments, options.requested, options.judging);
  }
  return grade_many(context, mine, records, csv.has_value(), options);
}

const RegisterCommand grade_command{
    {.usage =
         "grade DIR|ZIP... [--lab LAB] [--csv FILE [--resume]] [--roster FILE] [--html DIR] ...",
     .details =
         "Grades every lab that has a file in DIR: at its top, in starter/, or anywhere below. A "
         "directory or zip file with the work of several people, as Gradescope, Canvas and Moodle "
         "export it, counts as one submission per person. One submission gets a report of each "
         "check, and plots; several get one line each. Try: ./lab grade solutions.\n"
         "Exit status: 0 all are judged, 2 bad usage, 3 the machine failed: some submissions are "
         "not judged and have no points.",
     .options =
         {{"--lab LAB,…", "grade only these labs (--lab 1,2); a missing file earns 0 points"},
          {"--csv FILE",
           "write a row for each submission as soon as it is judged, and its full verdict "
           "to FILE-verdicts/"},
          {"--resume",
           "continue a run with the same FILE and its seed; changed submissions and those "
           "that were not judged are judged again"},
          {"--roster FILE",
           "a row for each student of this list, with name, e-mail address, time of "
           "submission and LATE mark; the file has the columns id, name, email, or is what "
           "Canvas, Moodle or Gradescope exports"},
          {"--with-reference", "use the solutions of the labs that a lab depends on"},
          {"--html DIR",
           "write DIR/index.html with all points and what ./lab stats shows, and a page for "
           "each submission"},
          {"--json FILE", "write Gradescope's results.json (one DIR)"},
          {"--leaderboard",
           "with --json: publish the speed relative to the reference to the class"},
          {"--visibility V", "with --json: visible, hidden, after_due_date or after_published"},
          {"--seed S", "use this seed"},
          {"--jobs N, -j N",
           "run N jobs at once: submissions, or checks of a single one (all cores)"},
          {"--speed", "also measure the speed tasks; for several submissions, at the end, in turn"},
          {"--shard k/n",
           "every n-th submission from the k-th on, for n machines; ./lab merge merges the "
           "tables"},
          {"--slurm", "with --csv: submit a cluster task per submission; --resume collects them"},
          {"--no-plots", "no plots"}},
     .run = grade,
     .least_words = 1}};

}  // namespace
}  // namespace mc::grader
