#pragma once
// What everything in the grader knows: where things are, and the labs there are.

#include <vector>

#include "grader/context/labs.hpp"
#include "grader/context/layout.hpp"

namespace mc::grader {

struct Context {
  Layout layout;
  std::vector<Lab> labs;
};

}  // namespace mc::grader
