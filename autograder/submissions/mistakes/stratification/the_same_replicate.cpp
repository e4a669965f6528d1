// mistake: starts every replicate with a copy of the same generator
// caught by: 3.8 the estimate is the mean of the replicates
// caught by: 3.8 the error bar is honest for stratified points
// hint: fresh points from the same generator
#include "stratification.hpp"
#define estimate_replicated right_estimate_replicated
#include "solutions/stratification.cpp"
#undef estimate_replicated

namespace mc {

Estimate estimate_replicated(const Integrand& g, const Generator& generator, std::uint64_t n,
                             std::uint64_t replicates, Rng& rng) {
  const Generator same = [&](PointSet& points, Rng&) {
    Rng copy = rng;
    generator(points, copy);
  };
  return right_estimate_replicated(g, same, n, replicates, rng);
}

}  // namespace mc
