// mistake: divides the spread of the means by sqrt(n replicates)
// caught by: 3.8 the error bar is the spread of the replicates
// caught by: 3.8 the error bar is honest for stratified points
// hint: divide by sqrt(replicates), the number of means
#include "stratification.hpp"

#include <cmath>

#define estimate_replicated right_estimate_replicated
#include "solutions/stratification.cpp"
#undef estimate_replicated

namespace mc {

Estimate estimate_replicated(const Integrand& g, const Generator& generator, std::uint64_t n,
                             std::uint64_t replicates, Rng& rng) {
  Estimate estimate = right_estimate_replicated(g, generator, n, replicates, rng);
  estimate.standard_error /= std::sqrt(static_cast<double>(n));
  return estimate;
}

}  // namespace mc
