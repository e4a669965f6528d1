#include "grader/gradebook/batch.hpp"

#include <algorithm>
#include <atomic>
#include <mutex>
#include <numeric>
#include <set>

#include "grader/base/side_by_side.hpp"
#include "grader/judging/budget.hpp"
#include "grader/reports/progress_line.hpp"
#include "grader/reports/report.hpp"
#include "grader/submission/compile.hpp"
#include "grader/submission/scratch.hpp"
#include "grader/submission/source.hpp"

namespace mc::grader {
namespace {

/// The size limit of build/programs.
constexpr std::size_t most_programs = std::size_t{300} << 20;

/// After this many submissions in a row without a verdict, the machine is tested.
constexpr int most_failures = 3;

/// Everything submitted that a verdict depends on.
std::string everything_in(const IntakeEntry& entry, const JudgeOptions& options) {
  return fmt::format("{}\n{}\n{}{}", entry.unreadable, entry.submission.found_in,
                     contents_of(entry.submission.files),
                     options.with_reference ? "on the reference's files\n" : "");
}

/// Did the machine, and not only the autograder, prevent judging?
bool has_machine_failed(const Verdict& verdict) {
  if (verdict.not_judged.empty()) return false;
  return verdict.labs.empty() || std::ranges::any_of(verdict.labs, [](const LabVerdict& lab) {
           return std::ranges::any_of(
               lab.checks, [](const CheckResult& one) { return one.status == Status::not_judged; });
         });
}

std::vector<std::string> absent_from(const Context& context, const Submission& submission) {
  std::vector<std::string> absent;
  for (const Lab& lab : context.labs) {
    if (!submission.files.contains(lab.name)) absent.push_back(lab.name);
  }
  return absent;
}

class Batch {
 public:
  Batch(const Context& context, const std::vector<IntakeEntry>& entries, Book* book,
        const BatchOptions& options)
      : context_(context), entries_(entries), book_(book), options_(options) {
    for (const IntakeEntry& one : entries) {
      widest_ = std::max(widest_, std::min<std::size_t>(columns_of(one.submission.label), 40));
    }
  }

  BatchOutcome run() {
    find_known();
    {
      ProgressLine line("grading");
      line_ = &line;
      parts_.assign(open_.size(), 0);
      run_side_by_side(open_.size(), options_.workers, [&](std::size_t i) { judge(i); });
      line_ = nullptr;
    }
    if (options_.with_speed && outcome_.stopped.empty()) measure();
    return outcome_;
  }

 private:
  void find_known() {
    for (std::size_t i = 0; i < entries_.size(); ++i) {
      const IntakeEntry& one = entries_[i];
      const auto labs = labs_of(context_, one.submission, options_.requested);
      auto known = known_verdict(one, labs);
      if (!known) {
        open_.push_back(i);
        continue;
      }
      ++outcome_.known;
      outcome_.unreadable += known->unreadable.empty() ? 0 : 1;
      if (known->delivery != one.submission.delivery) {  // the roster may be newer
        known->delivery = one.submission.delivery;
        book_->update(*known);
      }
      book_->keep(*known);
    }
    if (book_ != nullptr) book_->begin();
  }

  std::optional<Verdict> known_verdict(const IntakeEntry& one, const std::vector<Lab>& labs) const {
    if (book_ == nullptr) return {};
    try {
      return book_->known(one.submission.label, judged_labs(one, labs),
                          everything_in(one, options_.judging.judge));
    } catch (const std::exception&) {  // judge it again, which reports the error
      return {};
    }
  }

  static std::vector<Lab> judged_labs(const IntakeEntry& entry, const std::vector<Lab>& labs) {
    return entry.unreadable.empty() ? labs : std::vector<Lab>();
  }

  void judge(std::size_t at) {
    if (is_stopped_) return;
    const IntakeEntry& one = entries_[open_[at]];
    SubmissionOptions options = options_.judging;
    options.judge.workers = 1;
    options.with_speed = false;
    options.progress = [&](double done, double all, const std::string&) {
      show_progress(at, all > 0 ? done / all : 0);
    };
    const auto labs = labs_of(context_, one.submission, options_.requested);
    const Verdict verdict = judge_entry(context_, one, labs, options);
    if (book_ != nullptr) book_->add(verdict);
    show_progress(at, 1);
    report(verdict);
    sweep(one);
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

  /// Timed alone: other jobs would disturb the measurement.
  void measure() {
    if (book_ == nullptr) return;
    ProgressLine line("timing");
    for (std::size_t i = 0; i < entries_.size(); ++i) {
      line.show(static_cast<double>(i), static_cast<double>(entries_.size()), "timed");
      const IntakeEntry& one = entries_[i];
      auto verdict = book_->read(one.submission.label);
      if (!verdict || !verdict->not_judged.empty() || !verdict->unreadable.empty()) continue;
      bool changed = false;
      for (LabVerdict& lab : verdict->labs) {
        // Timed before it was interrupted, or on files that are not its own.
        if (!lab.speed.empty() || !lab.on_reference.empty()) continue;
        add_speed(context_, one.submission, lab);
        changed |= !lab.speed.empty();
      }
      if (changed) book_->update(*verdict);
    }
  }

  const Context& context_;
  const std::vector<IntakeEntry>& entries_;
  Book* const book_;
  const BatchOptions& options_;
  std::size_t widest_ = 10;
  std::vector<std::size_t> open_;  ///< submissions still to be judged
  ProgressLine* line_ = nullptr;

  std::mutex mutex_;
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
    const bool has_hours = std::ranges::any_of(
        entries, [&](auto& one) { return one.submission.delivery.hours.contains(lab.name); });
    columns.push_back({lab, {}, has_hours});
    for (const Check& check : expected_checks(context.layout, lab)) {
      columns.back().checks.push_back(check.name);
    }
  }
  return columns;
}

Verdict judge_entry(const Context& context, const IntakeEntry& entry, const std::vector<Lab>& labs,
                    SubmissionOptions options) {
  Verdict verdict;
  std::string contents;
  // An exception only affects its own submission: MachineError, a full disk, no memory.
  try {
    Budget budget;
    options.judge.budget = &budget;
    contents = everything_in(entry, options.judge);
    if (entry.unreadable.empty()) {
      verdict = judge_submission(context, entry.submission, labs, options);
    }
  } catch (const std::exception& error) {
    verdict.not_judged = error.what();
  }
  verdict.submission = entry.submission.label;
  verdict.found_in = entry.submission.found_in;
  verdict.delivery = entry.submission.delivery;
  verdict.contents = std::move(contents);
  verdict.seed = options.judge.seed;
  verdict.version = context.layout.version;
  verdict.jail_complete = sandbox::jail_is_complete();
  verdict.reads_confined = sandbox::places_are_enforced();
  verdict.unreadable = entry.unreadable;
  if (verdict.absent.empty()) verdict.absent = absent_from(context, entry.submission);
  return verdict;
}

BatchOutcome run_batch(const Context& context, const std::vector<IntakeEntry>& entries, Book* book,
                       const BatchOptions& options) {
  return Batch(context, entries, book, options).run();
}

}  // namespace mc::grader
