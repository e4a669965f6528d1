#pragma once
// Judges many submissions in parallel.

#include "classes/verdict_store.hpp"
#include "judge/judging/judge_submission.hpp"
#include "judge/reports/csv.hpp"
#include "judge/submission/intake.hpp"

namespace mc::grader {

/// The labs to judge: those asked for, even if files are missing; else those that the submission
/// has a file of.
std::vector<Lab> labs_of(const Context& context, const Submission& submission,
                         const std::vector<Lab>& requested);

/// The table columns for these submissions.
std::vector<LabColumns> columns_for(const Context& context, const std::vector<IntakeEntry>& entries,
                                    const std::vector<Lab>& requested);

/// Always returns a verdict: if the machine fails, the verdict says so instead of a grade.
Verdict judge_entry(const Context& context, const IntakeEntry& entry, const std::vector<Lab>& labs,
                    SubmissionOptions options);

struct BatchOptions {
  SubmissionOptions judging;
  unsigned workers = 1;        ///< submissions at the same time
  std::vector<Lab> requested;  ///< empty: the labs that were handed in
};

struct BatchOutcome {
  std::vector<Verdict> verdicts;  ///< in the order of the entries; of those that were tried
  std::size_t judged = 0, known = 0, unreadable = 0, not_judged = 0;
  std::string stopped;  ///< why the rest was not tried, if the machine fails every time
};

/// Judges the submissions, prints a line for each as it finishes, and stores each (null: nowhere)
/// before its worker starts another.
BatchOutcome run_batch(const Context& context, const std::vector<IntakeEntry>& entries,
                       const VerdictStore* store, const BatchOptions& options);

}  // namespace mc::grader
