// mistake: -log(u) / rate: the right distribution, but falling in u and infinite at u = 0
// caught by: 2.3 exponential samples
// hint: it falls when u rises, and at u = 0 it is infinite
#include "independent.hpp"

#define sample_exponential right_sample_exponential
#include "solutions/independent.cpp"
#undef sample_exponential

namespace mc {

double sample_exponential(double u, double rate) {
  require_rate(rate);
  return -std::log(u) / rate;
}

}  // namespace mc
