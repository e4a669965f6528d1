// check, grade: submissions to verdicts to reports.

#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <functional>
#include <future>
#include <map>
#include <random>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "grader/errors.hpp"
#include "grader/judge.hpp"
#include "grader/plots.hpp"
#include "grader/report.hpp"
#include "grader/speed.hpp"
#include "grader/standing.hpp"
#include "grader/text_file.hpp"
#include "grader/verbs.hpp"

namespace mc::grader {
namespace fs = std::filesystem;
namespace {

using Clock = std::chrono::steady_clock;

std::uint64_t seed_of(const Arguments& arguments) {
  // Fresh for every run, so that nothing can be made to fit it; short, so that it can be typed.
  return arguments.number("seed").value_or(std::random_device()() % 1'000'000'000);
}

/// Looked at before any work is done: a mistyped name should not cost a grade.
void require_writable(const std::optional<std::string>& file) {
  if (!file) return;
  const fs::path directory = fs::absolute(*file).parent_path();
  if (!fs::is_directory(directory)) {
    throw UsageError(fmt::format("no such directory: {}", directory.string()));
  }
}

/// Does the submission have full marks in this lab? Judged now, unless it was already.
class Finished {
 public:
  Finished(const House& house, const Submission& submission, const JudgeOptions& options)
      : house_(house), submission_(submission), options_(options) {
    options_.only.clear();
  }

  void add(const LabVerdict& verdict) {
    known_[std::to_string(verdict.lab.number)] = verdict.earned() == verdict.points();
  }

  bool operator()(const std::string& number) {
    if (!known_.contains(number)) {
      const Lab& lab = find_lab(house_.labs, number);
      add(judge_lab(house_.layout, lab, build_program(house_.layout, lab, submission_), options_));
    }
    return known_[number];
  }

 private:
  const House& house_;
  const Submission& submission_;
  JudgeOptions options_;
  std::map<std::string, bool> known_;
};

/// Without the library's assertions, which what is judged has.
Built build_fast(const House& house, const Submission& submission, const Lab& lab) {
  return build_program(house.layout, lab, submission, Variant::speed);
}

/// How fast the lab's speed tasks are, where there is something to run.
void add_speed(const House& house, LabVerdict& judged, const Built& fast) {
  if (!fast.program) return;
  if (judged.no_program.empty()) judged.speed = measure_speed(house.layout, judged, *fast.program);
  close(fast.program->descriptor);
}

/// `speed_later` leaves the speed tasks to the caller: somebody waits for the verdict.
Verdict judge_submission(const House& house, const Submission& submission,
                         const std::vector<Lab>& labs, JudgeOptions options,
                         bool speed_later = false) {
  const auto start = Clock::now();
  Verdict verdict;
  verdict.submission = submission.label;
  verdict.seed = options.seed;
  verdict.version = house.layout.version;
  verdict.flags = fmt::format("{}", fmt::join(compile_flags(Variant::judged), " "));
  verdict.jail_complete = jail_is_complete();
  options.submission = submission.label;
  Finished finished(house, submission, options);
  for (const Lab& lab : labs) {
    std::future<Built> fast;
    if (options.only.empty() && !speed_later) {
      fast = std::async(std::launch::async, [&] { return build_fast(house, submission, lab); });
    }
    const Built built = build_program(house.layout, lab, submission);
    LabVerdict judged = judge_lab(house.layout, lab, built, options);
    wait_for_labs(judged, std::ref(finished));
    if (options.only.empty()) finished.add(judged);
    if (fast.valid()) add_speed(house, judged, fast.get());
    verdict.labs.push_back(std::move(judged));
  }
  for (const Lab& lab : house.labs) {
    if (!submission.files.contains(lab.name)) verdict.absent.push_back(lab.name);
  }
  verdict.seconds = std::chrono::duration<double>(Clock::now() - start).count();
  return verdict;
}

std::vector<Lab> labs_in(const House& house, const Submission& submission) {
  std::vector<Lab> present;
  for (const Lab& lab : house.labs) {
    if (submission.files.contains(lab.name)) present.push_back(lab);
  }
  return present;
}

void show_plots(const House& house, const Submission& submission, const std::vector<Lab>& labs) {
  std::string folder = submission.label;
  std::replace_if(
      folder.begin(), folder.end(), [](char c) { return c == '/' || c == '\\'; }, '_');
  for (const Lab& lab : labs) {
    const Plots plots = draw_plots(house.layout, lab, {submission}, folder);
    for (const std::string& remark : plots.remarks) fmt::print("{}\n", remark);
    for (const fs::path& picture : plots.pictures) {
      if (picture.extension() == ".png") fmt::print("plot: {} (and .svg)\n", picture.string());
    }
  }
}

}  // namespace

int check(const House& house, const Arguments& arguments) {
  if (arguments.words.empty() || arguments.words.size() > 2) {
    throw UsageError("usage: ./lab check LAB [DIR] (LAB is 1, variance or 1-variance)");
  }
  const Lab& lab = find_lab(house.labs, arguments.words[0]);
  const bool own = arguments.words.size() == 1;
  const fs::path directory = own ? house.layout.starter() : fs::path(arguments.words[1]);
  const auto json = arguments.get("json");
  require_writable(json);
  Submission submission = open_submission(house.layout, house.labs, directory);
  if (own) submission.label = "starter";
  // For a machine that reads results.json, a missing file is a grade like any other: none.
  if (!submission.files.contains(lab.name) && !json) {
    throw UsageError(fmt::format("{} has no {}", directory.string(), lab.file()));
  }
  JudgeOptions options;
  options.seed = seed_of(arguments);
  options.only = arguments.get("only").value_or("");
  Verdict verdict = judge_submission(house, submission, {lab}, options, true);
  LabVerdict& judged = verdict.labs[0];
  fmt::print("{}", report_lab(judged, verdict, this_terminal()));
  if (options.only.empty() && judged.no_program.empty()) {
    add_speed(house, judged, build_fast(house, submission, lab));
    if (!judged.speed.empty()) fmt::print("\n{}", report_speed(judged));
  }
  if (json) write_text(*json, report_json(verdict));
  if (own && options.only.empty()) remember(house.layout, judged);
  return verdict.earned() == verdict.points() ? 0 : 1;
}

int grade(const House& house, const Arguments& arguments) {
  if (arguments.words.empty())
    throw UsageError("usage: ./lab grade DIR... (try: ./lab grade solutions)");
  const auto json = arguments.get("json"), csv = arguments.get("csv");
  require_writable(json);
  require_writable(csv);
  if (json && arguments.words.size() > 1) {
    throw UsageError("--json takes one DIR; for several there is --csv");
  }
  JudgeOptions options;
  options.seed = seed_of(arguments);
  options.workers =
      static_cast<unsigned>(std::clamp<std::uint64_t>(arguments.number("jobs").value_or(2), 1, 64));
  std::vector<Submission> submissions;
  for (const std::string& word : arguments.words) {
    submissions.push_back(open_submission(house.layout, house.labs, word));
  }
  const bool single = submissions.size() == 1;
  std::vector<Verdict> verdicts;
  for (const Submission& submission : submissions) {
    const auto labs = labs_in(house, submission);
    if (labs.empty() && single && !json && !csv) {
      throw UsageError(fmt::format("{} has no file of any lab ({} …)", submission.label,
                                   house.labs.empty() ? "" : house.labs[0].file()));
    }
    verdicts.push_back(judge_submission(house, submission, labs, options));
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
    if (!arguments.has("no-plots")) show_plots(house, submission, labs);
  }
  if (!single) fmt::print("{}", jail_warning(verdicts[0]));
  if (json) write_text(*json, report_json(verdicts[0]));
  if (csv) write_text(*csv, report_csv(verdicts));
  return 0;
}

}  // namespace mc::grader
