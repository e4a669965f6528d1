#pragma once
// Runs the command that ./lab was called with.

namespace mc::grader {

/// Finds the command, runs it, and turns errors into a line and an exit status. The same for each of
/// the programs that share the commands. `argv` as main() has it.
int run_lab(char** argv);

}  // namespace mc::grader
