#pragma once
// Runs the command that ./lab was called with.

namespace mc::grader {

/// Finds the command, runs it, and turns errors into a line and an exit status. All programs that
/// share the commands use it. `argv` is that of main().
int run_lab(char** argv);

}  // namespace mc::grader
