#include "classes/batch.hpp"

#include <algorithm>
#include <atomic>
#include <mutex>
#include <numeric>
#include <set>

#include <fmt/format.h>

#include "judge/base/side_by_side.hpp"
#include "judge/base/text_file.hpp"
#include "judge/judging/budget.hpp"
#include "judge/reports/progress_line.hpp"
#include "judge/reports/report.hpp"
#include "judge/submission/compile.hpp"
#include "judge/submission/scratch.hpp"
#include "judge/submission/source.hpp"

namespace mc::grader {
namespace fs = std::filesystem;
namespace {

/// The size limit of build/programs.
constexpr std::size_t most_programs = std::size_t{300} << 20;

/// After this many submissions in a row without a verdict, the machine is tested.
constexpr int most_failures = 3;

/// A hash of everything submitted that a verdict depends on, 128 bits long.
std::string contents_hash(const IntakeEntry& entry, const JudgeOptions& options) {
  const std::string all = fmt::format("{}\n{}\n{}{}", entry.unreadable, entry.submission.found_in,
                                      contents_of(entry.submission.files),
                                      options.with_reference ? "on the reference's files\n" : "");
  return fmt::format("{:016x}{:016x}", hash_text(all), hash_text(all, hash_text("second")));
}

/// Did the machine, and not only the autograder, prevent judging?
bool has_machine_failed(const Verdict& verdict) {
  if (verdict.not_judged.empty()) return false;
  return verdict.labs.empty() || std::ranges::any_of(verdict.labs, [](const LabVerdict& lab) {
           return std::ranges::any_of(
               lab.checks, [](const CheckResult& one) { return one.status == Status::not_judged; });
         });
}

/// All that is known of a verdict before judging.
Verdict blank_verdict(const Context& context, const IntakeEntry& entry,
                      const JudgeOptions& options) {
  Verdict verdict;
  verdict.submission = entry.submission.label;
  verdict.found_in = entry.submission.found_in;
  verdict.seed = options.seed;
  verdict.version = context.layout.version;
  verdict.jail_complete = sandbox::jail_is_complete();
  verdict.reads_confined = sandbox::places_are_enforced();
  verdict.unreadable = entry.unreadable;
  verdict.others = entry.submission.others;
  for (const Lab& lab : context.labs) {
    if (!entry.submission.files.contains(lab.name)) verdict.absent.push_back(lab.name);
  }
  return verdict;
}

class Batch {
 public:
  Batch(const Context& context, const std::vector<IntakeEntry>& entries, const VerdictStore* store,
        const BatchOptions& options)
      : context_(context),
        entries_(entries),
        store_(store),
        options_(options),
        verdicts_(entries.size()),
        parts_(entries.size(), 0) {
    for (const IntakeEntry& one : entries) {
      widest_ = std::max(widest_, std::min<std::size_t>(columns_of(one.submission.label), 40));
    }
  }

  BatchOutcome run() {
    {
      ProgressLine line("grading");
      line_ = &line;
      run_side_by_side(entries_.size(), options_.workers, [&](std::size_t i) { judge(i); });
    }
    for (auto& verdict : verdicts_) {
      if (verdict) outcome_.verdicts.push_back(std::move(*verdict));
    }
    return std::move(outcome_);
  }

 private:
  void judge(std::size_t at) {
    if (is_stopped_) return;
    const IntakeEntry& one = entries_[at];
    const auto labs = labs_of(context_, one.submission, options_.requested);
    if (auto known = known_verdict(one, labs)) {
      const std::lock_guard lock(mutex_);
      ++outcome_.known;
      outcome_.unreadable += known->unreadable.empty() ? 0 : 1;
      verdicts_[at] = std::move(known);
      parts_[at] = 1;
      return;
    }
    SubmissionOptions options = options_.judging;
    options.judge.workers = 1;
    options.with_speed = false;
    options.progress = [&](double done, double all, const std::string&) {
      show_progress(at, all > 0 ? done / all : 0);
    };
    Verdict verdict = judge_entry(context_, one, labs, options);
    if (store_ != nullptr) store_->add(verdict);
    show_progress(at, 1);
    report(verdict);
    sweep(one);
    const std::lock_guard lock(mutex_);
    verdicts_[at] = std::move(verdict);
  }

  std::optional<Verdict> known_verdict(const IntakeEntry& one, const std::vector<Lab>& labs) const {
    if (store_ == nullptr) return {};
    try {
      Verdict wanted = blank_verdict(context_, one, options_.judging.judge);
      wanted.contents = contents_hash(one, options_.judging.judge);
      if (one.unreadable.empty()) {
        for (const Lab& lab : labs) wanted.labs.emplace_back().lab = lab;
      }
      return store_->known(wanted);
    } catch (const std::exception&) {  // judge it again, which reports the error
      return {};
    }
  }

  void show_progress(std::size_t at, double part) {
    const std::lock_guard lock(mutex_);
    parts_[at] = part;
    const double done = std::accumulate(parts_.begin(), parts_.end(), 0.0);
    const auto all = static_cast<double>(parts_.size());
    line_->show(done, all, fmt::format("submissions, {} at a time", options_.workers));
  }

  void report(const Verdict& verdict) {
    const std::lock_guard lock(mutex_);
    line_->clear();
    fmt::print("{}", report_summary({verdict}, widest_));
    if (!verdict.unreadable.empty()) {
      ++outcome_.unreadable;
    } else if (!verdict.not_judged.empty()) {
      ++outcome_.not_judged;
    } else {
      ++outcome_.judged;
    }
    failures_ = has_machine_failed(verdict) ? failures_ + 1 : 0;
    if (failures_ < most_failures) return;
    failures_ = 0;
    // Three submissions may cause this themselves: give up only if the machine fails with a known
    // program, too.
    try {
      probe_machine(context_.layout);
    } catch (const std::exception& error) {
      outcome_.stopped = error.what();
      is_stopped_ = true;
    }
  }

  void sweep(const IntakeEntry& done) {
    const std::lock_guard lock(mutex_);
    for (const auto& [lab, file] : done.submission.files) {
      const Lab& owner = find_lab(context_.labs, lab);
      done_with_.insert(slot_of({context_.layout, owner, file, done.submission.trusted}));
    }
    sweep_programs(context_.layout, most_programs, done_with_);
  }

  const Context& context_;
  const std::vector<IntakeEntry>& entries_;
  const VerdictStore* const store_;
  const BatchOptions& options_;
  std::size_t widest_ = 10;
  ProgressLine* line_ = nullptr;

  std::mutex mutex_;
  std::vector<std::optional<Verdict>> verdicts_;
  std::vector<double> parts_;
  BatchOutcome outcome_;
  int failures_ = 0;
  std::atomic<bool> is_stopped_ = false;
  std::set<fs::path> done_with_;
};

}  // namespace

std::vector<Lab> labs_of(const Context& context, const Submission& submission,
                         const std::vector<Lab>& requested) {
  if (!requested.empty()) return requested;
  std::vector<Lab> present;
  for (const Lab& lab : context.labs) {
    if (submission.files.contains(lab.name)) present.push_back(lab);
  }
  return present;
}

std::vector<LabColumns> columns_for(const Context& context, const std::vector<IntakeEntry>& entries,
                                    const std::vector<Lab>& requested) {
  std::vector<LabColumns> columns;
  for (const Lab& lab : context.labs) {
    const bool is_judged = std::ranges::any_of(entries, [&](auto& one) {
      const auto labs = labs_of(context, one.submission, requested);
      return std::ranges::any_of(labs, [&](auto& a) { return a.name == lab.name; });
    });
    if (!is_judged) continue;
    columns.push_back({lab, {}});
    for (const Check& check : expected_checks(context.layout, lab)) {
      columns.back().checks.push_back(check.name);
    }
  }
  return columns;
}

Verdict judge_entry(const Context& context, const IntakeEntry& entry, const std::vector<Lab>& labs,
                    SubmissionOptions options) {
  Verdict verdict = blank_verdict(context, entry, options.judge);
  // An exception only affects its own submission: MachineError, a full disk, no memory.
  try {
    Budget budget;
    options.judge.budget = &budget;
    verdict.contents = contents_hash(entry, options.judge);
    if (entry.unreadable.empty()) {
      Verdict judged = judge_submission(context, entry.submission, labs, options);
      verdict.labs = std::move(judged.labs);
      verdict.flags = std::move(judged.flags);
      verdict.not_judged = std::move(judged.not_judged);
      verdict.seconds = judged.seconds;
    }
  } catch (const std::exception& error) {
    verdict.not_judged = error.what();
  }
  return verdict;
}

BatchOutcome run_batch(const Context& context, const std::vector<IntakeEntry>& entries,
                       const VerdictStore* store, const BatchOptions& options) {
  return Batch(context, entries, store, options).run();
}

}  // namespace mc::grader
