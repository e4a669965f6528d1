#pragma once
// The checks of one task on one program, one after the other, each in a process of its own.

#include <vector>

#include "grader/judging/judge.hpp"

namespace mc::grader {

/// Runs the checks of a task, in order, and fills in what became of each. `done` is called after
/// each check.
void run_task(const Layout& layout, const Lab& lab, const sandbox::Program& program,
              const JudgeOptions& options, const std::vector<CheckResult*>& checks,
              const std::function<void()>& done);

}  // namespace mc::grader
