// mistake: the density of the power distribution lacks its factor a + 1
// caught by: 2.3 the densities
// hint: x^a alone gives 1 / (a + 1)
#include "independent.hpp"

#define pdf_power right_pdf_power
#include "solutions/independent.cpp"
#undef pdf_power

namespace mc {

double pdf_power(double x, double a) {
  require_power(a);
  return x < 0 || x > 1 ? 0 : std::pow(x, a);
}

}  // namespace mc
