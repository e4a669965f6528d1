#pragma once

#include <stdexcept>

namespace mc {

/// Thrown by a task that is not written yet. The autograder knows it and reports the task as
/// «not written yet» instead of as a mistake.
struct todo : std::logic_error {
  explicit todo(const char* task) : std::logic_error(task) {}
};

}  // namespace mc
