// mistake: one replicate is given an error bar of zero
// caught by: 3.8 one replicate has no error bar
// hint: what is undefined
#include "stratification.hpp"
#define estimate_replicated right_estimate_replicated
#include "solutions/stratification.cpp"
#undef estimate_replicated

namespace mc {

Estimate estimate_replicated(const Integrand& g, const Generator& generator, std::uint64_t n,
                             std::uint64_t replicates, Rng& rng) {
  Estimate estimate = right_estimate_replicated(g, generator, n, replicates, rng);
  if (replicates == 1) estimate.standard_error = 0;
  return estimate;
}

}  // namespace mc
