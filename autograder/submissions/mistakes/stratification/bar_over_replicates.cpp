// mistake: divides the squared deviations by replicates where replicates - 1 is due
// caught by: 3.8 the error bar is the spread of the replicates
// hint: a sample variance divides by replicates - 1
#include "stratification.hpp"

#include <cmath>

#define estimate_replicated right_estimate_replicated
#include "solutions/stratification.cpp"
#undef estimate_replicated

namespace mc {

Estimate estimate_replicated(const Integrand& g, const Generator& generator, std::uint64_t n,
                             std::uint64_t replicates, Rng& rng) {
  Estimate estimate = right_estimate_replicated(g, generator, n, replicates, rng);
  const auto r = static_cast<double>(replicates);
  estimate.standard_error *= std::sqrt((r - 1) / r);
  return estimate;
}

}  // namespace mc
