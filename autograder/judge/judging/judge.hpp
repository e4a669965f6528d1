#pragma once
// From a program to a verdict: runs a lab's checks, one process each, and reads their records.

#include <cstdint>
#include <filesystem>
#include <functional>
#include <set>
#include <string>

#include "judge/judging/budget.hpp"
#include "judge/judging/check_process.hpp"
#include "judge/judging/verdict.hpp"
#include "judge/submission/build.hpp"
#include "sandbox/process.hpp"

namespace mc::grader {

struct JudgeOptions {
  std::uint64_t seed = 0;
  std::set<std::string> checks = {};  ///< judge only the checks with these names; empty: all
  std::string only;                   ///< a task ("1.3"): judge only its checks; empty: all
  bool first = false;                 ///< stop after the first task that lacks points
  unsigned workers = 2;               ///< tasks judged at the same time
  /// The directory or zip, for the command that repeats a check; empty: the student's own.
  std::string submission;
  Budget* budget = nullptr;  ///< of the whole submission; null: none
  /// The reference's files take the place of the submission's in the labs that a lab depends on.
  bool with_reference = false;
  /// Called after each check with the numbers of finished and of all checks; never concurrently.
  std::function<void(std::size_t done, std::size_t all)> progress = {};
};

/// The limit of one task with all its checks: only endless programs reach it. Correct answers take
/// a thirtieth of it at most.
constexpr double task_cpu_seconds = 60;

/// The checks of a lab, from running them without a program. Throws MachineError if the lab's
/// checks are not built.
std::vector<Check> expected_checks(const Layout& layout, const Lab& lab);

/// A verdict depends only on the program, not on the machine's speed or load nor on the number of
/// workers: one worker judges a task, check after check, within a budget of CPU time. A check
/// depends only on its own measurements.
LabVerdict judge_lab(const Layout& layout, const Lab& lab, const BuildResult& built,
                     const JudgeOptions& options);

/// Marks a failed check as waiting if it needs another lab ("3") or task ("1.4") without full
/// marks, according to `is_finished`, which is called only if it matters.
void wait_for_labs(LabVerdict& verdict,
                   const std::function<bool(const std::string& need)>& is_finished);

/// The program of a lab that contains a hidden case: its checks (the speed tasks), or its
/// measurements (for plots, benchmark and demo).
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
