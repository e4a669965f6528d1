#pragma once
// The interactive page: what a slider teaches in each lab, with the points of a submission.

#include <string>
#include <vector>

#include "grader/checkout/context.hpp"
#include "grader/submission/submission.hpp"

namespace mc::grader {

struct Demo {
  std::string page;                  ///< self-contained; empty if there is nothing to show
  std::vector<std::string> remarks;  ///< what could not be measured, and why
};

/// Measures every lab that has a hidden case tagged [.demo].
Demo make_demo(const Context& context, const Submission& submission);

}  // namespace mc::grader
