#pragma once
// The hours that a student reports with the answers to a lab's written questions.

#include <vector>

#include "grader/checkout/labs.hpp"
#include "grader/submission/submission.hpp"

namespace mc::grader {

/// Reads answers/LAB.md, next to each lab's file or to its starter/: the last line "Hours …: 7.5".
/// Sets delivery.hours of the labs that have such a line with a text after the colon.
void read_hours(const std::vector<Lab>& labs, Submission& submission);

}  // namespace mc::grader
