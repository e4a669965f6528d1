#pragma once
// The experiments of a lab, as its experiments.cpp lists them for ./lab run.

#include <string>
#include <vector>

#include "grader/checkout/labs.hpp"
#include "grader/checkout/layout.hpp"

namespace mc::grader {

struct Experiment {
  std::string name;
  std::vector<std::string> parameters;  ///< their names, in order
};

/// In the order of the list; empty if the lab has none.
std::vector<Experiment> experiments_of(const Layout& layout, const Lab& lab);

}  // namespace mc::grader
