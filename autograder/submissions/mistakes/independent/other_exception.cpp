// mistake: refuses with std::domain_error
// caught by: 2.3 parameters
// hint: threw
#include "independent.hpp"

#define sample_exponential right_sample_exponential
#include "solutions/independent.cpp"
#undef sample_exponential

namespace mc {

double sample_exponential(double u, double rate) {
  if (!(rate > 0)) throw std::domain_error("rate");
  return right_sample_exponential(u, rate);
}

}  // namespace mc
