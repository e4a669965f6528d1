#pragma once

#include <vector>

#include "grader/checkout/context.hpp"
#include "grader/checkout/labs.hpp"

namespace mc::grader {

/// Writes labs/N-name/speed.tsv of each lab: the solutions' times for its speed tasks.
void calibrate(const Context& context, const std::vector<Lab>& labs, unsigned rounds);

}  // namespace mc::grader
