// mistake: gives the spread of one replicate as the error of the mean of all
// caught by: 3.8 the error bar is the spread of the replicates
// caught by: 3.8 the error bar is honest for stratified points
// hint: this is the standard deviation of one mean
#include "stratification.hpp"

#include <cmath>

#define estimate_replicated right_estimate_replicated
#include "solutions/stratification.cpp"
#undef estimate_replicated

namespace mc {

Estimate estimate_replicated(const Integrand& g, const Generator& generator, std::uint64_t n,
                             std::uint64_t replicates, Rng& rng) {
  Estimate estimate = right_estimate_replicated(g, generator, n, replicates, rng);
  estimate.standard_error *= std::sqrt(static_cast<double>(replicates));
  return estimate;
}

}  // namespace mc
