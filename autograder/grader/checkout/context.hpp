#pragma once
// What everything in the grader knows: where things are, and the labs there are.

#include <vector>

#include "grader/checkout/labs.hpp"
#include "grader/checkout/layout.hpp"

namespace mc::grader {

struct Context {
  Layout layout;
  std::vector<Lab> labs;
};

}  // namespace mc::grader
