// mistake: takes the a-th root: integrating raises the exponent
// caught by: 2.3 power samples
// hint: integrating x^a raises the exponent
#include "independent.hpp"

#define sample_power right_sample_power
#include "solutions/independent.cpp"
#undef sample_power

namespace mc {

double sample_power(double u, double a) {
  require_power(a);
  return std::pow(u, 1 / a);
}

}  // namespace mc
