#pragma once
// The experiments of a lab, for running them by hand.

#include <cstddef>
#include <string>

#include "runner/experiment.hpp"

namespace mc::runner {

/// Each with its parameters by name and what it does, in lines of `width` columns at most.
std::string list_of_experiments(std::size_t width);

/// How one is called: "welford --x LIST".
std::string call_of(const Experiment& experiment);

}  // namespace mc::runner
