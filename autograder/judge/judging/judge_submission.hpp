#pragma once
// Judges a submission: builds its programs, judges its labs, measures its speed.

#include <vector>

#include "judge/checkout/labs.hpp"
#include "judge/judging/judge.hpp"

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

/// Measures the lab's speed tasks if there is a program.
void add_speed(const Context& context, const Submission& submission, LabVerdict& judged);

}  // namespace mc::grader
