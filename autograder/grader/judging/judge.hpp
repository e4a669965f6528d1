#pragma once
// From a program to a verdict: runs a lab's checks, one process each, and reads their records.

#include <cstdint>
#include <functional>
#include <set>
#include <string>

#include "grader/judging/budget.hpp"
#include "grader/judging/check_process.hpp"
#include "grader/judging/verdict.hpp"
#include "grader/submission/build.hpp"
#include "sandbox/process.hpp"

namespace mc::grader {

struct JudgeOptions {
  std::uint64_t seed = 0;
  std::set<std::string> checks = {};  ///< judge those of these names alone; empty: all
  std::string only;                   ///< a task ("1.3"): judge its checks alone; empty: all
  bool first = false;                 ///< stop after the first task that has not all its points
  unsigned workers = 2;               ///< tasks at the same time
  /// The directory or zip, for the command that repeats a check; empty: the student's own.
  std::string submission;
  Budget* budget = nullptr;  ///< of the whole submission; null: none
  /// Told after each check: how many are done, of how many. Called by one worker at a time.
  std::function<void(std::size_t done, std::size_t all)> progress = {};
};

/// What one task may use, all its checks together: only endless programs meet it. Correct answers
/// take a thirtieth of it at most.
constexpr double task_cpu_seconds = 60;

/// The checks of a lab, from a run of them without a program. Throws MachineError where the lab's
/// checks are not built.
std::vector<Check> expected_checks(const Layout& layout, const Lab& lab);

/// A verdict depends on the program alone, not on the machine's speed or load nor on the number of
/// workers: a task is judged by one worker, check after check, within a budget of CPU time. A check
/// depends on its own measurements only.
LabVerdict judge_lab(const Layout& layout, const Lab& lab, const BuildResult& built,
                     const JudgeOptions& options);

/// A failed check that needs another lab ("3"), or a task of one ("1.4"), is waiting while that is
/// short of full marks, as `is_finished` says; it is asked only where it matters.
void wait_for_labs(LabVerdict& verdict,
                   const std::function<bool(const std::string& need)>& is_finished);

/// Which of a lab's programs has a hidden case: its checks (the speed tasks), or its measurements
/// (for plots, benchmark and demo).
enum class CaseKind { checks, measurements };

/// The names of a lab's hidden cases with this tag.
std::vector<std::string> hidden_cases(const Layout& layout, const Lab& lab, CaseKind kind,
                                      const std::string& tag);

/// Runs the hidden cases with this tag, or the one of this name, on a program. `options` has their
/// request and time limit; their records say how they ended.
CheckProcess run_hidden_cases(const Layout& layout, const Lab& lab, CaseKind kind,
                              const sandbox::Program& program, const std::string& which,
                              sandbox::ProcessOptions options);

}  // namespace mc::grader
