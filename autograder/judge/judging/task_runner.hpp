#pragma once
// Runs the checks of one task on one program in turn, each in its own process.

#include <vector>

#include "judge/judging/judge.hpp"

namespace mc::grader {

/// Runs the checks of a task, in order, and fills in their results. Calls `done` after each check.
void run_task(const Layout& layout, const Lab& lab, const sandbox::Program& program,
              const JudgeOptions& options, const std::vector<CheckResult*>& checks,
              const std::function<void()>& done);

}  // namespace mc::grader
