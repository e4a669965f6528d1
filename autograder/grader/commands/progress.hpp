#pragma once
// The outcome of the last check of each lab, stored in the build directory for `./lab` alone.

#include <optional>
#include <string>

#include "grader/judging/verdict.hpp"

namespace mc::grader {

struct Progress {
  double earned = 0, points = 0;
  std::string next;         ///< the task to do next; empty when there is none
  bool is_current = false;  ///< the file has not changed since then
};

void remember(const Layout& layout, const LabVerdict& verdict);
std::optional<Progress> recall(const Layout& layout, const Lab& lab);

}  // namespace mc::grader
