// mistake: the density of the exponential goes on below 0
// caught by: 2.3 the densities
// hint: the density is 0 where the distribution does not reach
#include "independent.hpp"

#define pdf_exponential right_pdf_exponential
#include "solutions/independent.cpp"
#undef pdf_exponential

namespace mc {

double pdf_exponential(double x, double rate) {
  require_rate(rate);
  return rate * std::exp(-rate * x);
}

}  // namespace mc
