#pragma once
// The outcome of the last check of each lab, stored in the build directory for `./lab` alone.

#include "commands/command.hpp"
#include "judge/judging/verdict.hpp"

namespace mc::grader {

struct Progress {
  double earned = 0, points = 0;
  std::string next;         ///< the task to do next; empty when there is none
  bool is_current = false;  ///< the file has not changed since then
};

void write_progress(const Layout& layout, const LabVerdict& verdict);

/// The first task that fails, and how many verdicts in a row it has been that, this one included; 0
/// if no task fails.
std::pair<int, std::string> failures_in_a_row(const Layout& layout, const LabVerdict& verdict);

std::optional<Progress> read_progress(const Layout& layout, const Lab& lab);

}  // namespace mc::grader
