// mistake: -log(1 - u) / rate: 1 - u rounds a small u away
// caught by: 2.3 exponential samples
// hint: 1 - u forgets the last digits of a small u
#include "independent.hpp"

#define sample_exponential right_sample_exponential
#include "solutions/independent.cpp"
#undef sample_exponential

namespace mc {

double sample_exponential(double u, double rate) {
  require_rate(rate);
  return -std::log(1 - u) / rate;
}

}  // namespace mc
