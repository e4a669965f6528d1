// mistake: -log(u) / rate, and u = 0 is put right
// caught by: 2.3 exponential samples
// hint: this is -log(u) / rate, guarded or not
#include "independent.hpp"

#define sample_exponential right_sample_exponential
#include "solutions/independent.cpp"
#undef sample_exponential

namespace mc {

double sample_exponential(double u, double rate) {
  require_rate(rate);
  return -std::log(std::max(u, 1e-12)) / rate;
}

}  // namespace mc
