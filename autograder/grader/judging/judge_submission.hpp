#pragma once
// From a submission to a verdict: programs built, labs judged, speed measured.

#include <vector>

#include "grader/checkout/context.hpp"
#include "grader/judging/judge.hpp"

namespace mc::grader {

struct SubmissionOptions {
  JudgeOptions judge;
  bool with_speed = true;  ///< false: a user waits for the verdict; add_speed() comes later
  /// Called with the current step and the fraction of all work that is done.
  std::function<void(double done, double all, const std::string& what)> progress = {};
};

/// Judges these labs of a submission.
Verdict judge_submission(const Context& context, const Submission& submission,
                         const std::vector<Lab>& labs, const SubmissionOptions& options);

/// Measures how fast the lab's speed tasks are, where there is something to run.
void add_speed(const Context& context, const Submission& submission, LabVerdict& judged);

}  // namespace mc::grader
