// mistake: s^2 / n is given as the standard error, without the root
// caught by: 2.2 the standard error
// hint: this is the variance of the mean: take the square root
#include "independent.hpp"

#define estimate right_estimate
#include "solutions/independent.cpp"
#undef estimate

namespace mc {

Estimate estimate(const Integrand& g, std::uint64_t n, Rng& rng) {
  Estimate result = right_estimate(g, n, rng);
  result.standard_error *= result.standard_error;
  return result;
}

}  // namespace mc
