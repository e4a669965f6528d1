#pragma once
// ./lab, behind its door.

namespace mc::grader {

/// Finds the verb, runs it, and turns errors into a line and an exit status. The same for each of
/// the programs that share the verbs. `argv` as main() has it.
int run_lab(char** argv);

}  // namespace mc::grader
