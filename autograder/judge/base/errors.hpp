#pragma once
// The two ways in which a command ends early. Each carries one line for the user.

#include <stdexcept>

namespace mc::grader {

/// Bad usage, exit status 2: what is wrong and what to type instead.
struct UsageError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// The machine lacks something or fails, exit status 3, never a grade: the cause and the remedy.
struct MachineError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace mc::grader
