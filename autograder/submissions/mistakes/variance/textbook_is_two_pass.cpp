// mistake: a better algorithm under the name of the textbook's
// caught by: 1.2 the textbook formula loses everything under a large mean
// hint: this is a better algorithm under the textbook's name
#include "variance.hpp"
#define variance_textbook right_variance_textbook
#include "solutions/variance.cpp"
#undef variance_textbook

namespace mc {

double variance_textbook(std::span<const double> x) {
  return variance_two_pass(x);
}

}  // namespace mc
