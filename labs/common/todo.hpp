#pragma once

#include <stdexcept>

namespace mc {

/// Thrown by a task that is not implemented yet, with the task's number. The autograder reports the
/// task as "not written yet", not as a mistake.
struct todo : std::logic_error {
  explicit todo(const char* task) : std::logic_error(task) {}
};

}  // namespace mc
