#pragma once
// Many submissions, side by side.

#include <string>
#include <vector>

#include "grader/gradebook/book.hpp"
#include "grader/judging/judge_submission.hpp"
#include "grader/submission/intake.hpp"

namespace mc::grader {

/// What is judged of a submission: the labs asked for, whatever was handed in; without such, those
/// that it has a file of.
std::vector<Lab> labs_of(const Context& context, const Submission& submission,
                         const std::vector<Lab>& asked_for);

/// The columns of a table of these submissions.
std::vector<LabColumns> columns_for(const Context& context, const std::vector<IntakeEntry>& entries,
                                    const std::vector<Lab>& asked_for);

/// A verdict in any case: where the machine fails it says so instead of a grade.
Verdict judge_entry(const Context& context, const IntakeEntry& entry, const std::vector<Lab>& labs,
                    SubmissionOptions options);

struct BatchOptions {
  SubmissionOptions judging;
  unsigned workers = 1;        ///< submissions at the same time
  std::vector<Lab> asked_for;  ///< empty: what was handed in
  bool with_speed = false;     ///< measured in the end, one after the other
};

struct BatchOutcome {
  std::size_t judged = 0, known = 0, unreadable = 0, not_judged = 0;
  std::string stopped;  ///< why the rest was not tried, where the machine fails at everything
};

/// Judges them, prints a line for each as it comes, and writes each into the book (null: none)
/// before its worker begins another.
BatchOutcome run_batch(const Context& context, const std::vector<IntakeEntry>& entries, Book* book,
                       const BatchOptions& options);

}  // namespace mc::grader
