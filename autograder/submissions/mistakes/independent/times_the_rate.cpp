// mistake: multiplies by the rate where it should divide
// caught by: 2.3 exponential samples
// hint: divide by the rate
#include "independent.hpp"

#define sample_exponential right_sample_exponential
#include "solutions/independent.cpp"
#undef sample_exponential

namespace mc {

double sample_exponential(double u, double rate) {
  require_rate(rate);
  return -std::log1p(-u) * rate;
}

}  // namespace mc
