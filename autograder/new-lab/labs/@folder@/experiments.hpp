#pragma once
// What lab @number@ measures of a submission.

#include <vector>

#include "@lab@.hpp"
#include "runner/wire.hpp"

namespace mc::experiments {

/// @number@.1: of each value of x.
std::vector<double> squares(std::vector<double> x);

}  // namespace mc::experiments
