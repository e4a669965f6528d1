#pragma once
// The two ways in which a command ends early. Each carries one line for the person at the terminal.

#include <stdexcept>

namespace mc::grader {

/// Bad usage, exit status 2: what is wrong and how it goes.
struct UsageError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// The machine lacks something, or fails: exit status 3, and never a grade. What, and what to do.
struct MachineError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace mc::grader
