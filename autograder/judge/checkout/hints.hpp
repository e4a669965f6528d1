#pragma once
// The hints of a lab's tasks, from its hints.md: a section "## 4.3" for each task, and in it steps
// "### 1", "### 2", "### 3".

#include <string>
#include <vector>

#include "judge/checkout/labs.hpp"
#include "judge/checkout/layout.hpp"

namespace mc::grader {

/// The steps of a task, in order; none where the lab has no hints for it.
std::vector<std::string> hints_for(const Layout& layout, const Lab& lab, const std::string& task);

/// The text of a hints.md without the steps after the first `most` of each task.
std::string with_fewer_hints(const std::string& text, int most);

}  // namespace mc::grader
