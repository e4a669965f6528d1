#pragma once
// What all parts of the grader share: the layout of the checkout, and its labs.

#include <vector>

#include "grader/checkout/labs.hpp"
#include "grader/checkout/layout.hpp"

namespace mc::grader {

struct Context {
  Layout layout;
  std::vector<Lab> labs;
};

}  // namespace mc::grader
