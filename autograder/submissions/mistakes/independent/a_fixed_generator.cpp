// mistake: points come from a generator of its own, with a seed of its own
// caught by: 2.2 the estimate is the mean
// caught by: 2.2 exactly n
// caught by: 2.2 the standard error
// caught by: 2.2 a constant
// caught by: 2.2 one sample
// caught by: 2.2 the points are uniform
// caught by: 2.2 the estimate is unbiased
// caught by: 2.2 the error falls
// caught by: 2.2 rare events
// hint: take the numbers from rng, and from nowhere else
#include "independent.hpp"

#define estimate right_estimate
#include "solutions/independent.cpp"
#undef estimate

namespace mc {

Estimate estimate(const Integrand& g, std::uint64_t n, Rng&) {
  Rng own(42);
  return right_estimate(g, n, own);
}

}  // namespace mc
