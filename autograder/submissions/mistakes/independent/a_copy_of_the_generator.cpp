// mistake: works on a copy of the generator: every estimate sees the same points
// caught by: 2.2 the estimate is unbiased
// caught by: 2.2 the error falls
// caught by: 2.2 rare events
// hint: the generator must move on: is it copied somewhere?
#include "independent.hpp"

#define estimate right_estimate
#include "solutions/independent.cpp"
#undef estimate

namespace mc {

Estimate estimate(const Integrand& g, std::uint64_t n, Rng& rng) {
  Rng copy = rng;
  return right_estimate(g, n, copy);
}

}  // namespace mc
