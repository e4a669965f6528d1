// mistake: the loop begins at 1: n - 1 evaluations
// caught by: 2.2 exactly n evaluations
// caught by: 2.2 one sample
// caught by: 2.2 rare events
// hint: one is missing: does the loop begin at 1?
#include "independent.hpp"

#define estimate right_estimate
#include "solutions/independent.cpp"
#undef estimate

namespace mc {

Estimate estimate(const Integrand& g, std::uint64_t n, Rng& rng) {
  require_samples(n);
  std::vector<double> x(g.dims);
  Moments values;
  for (std::uint64_t i = 1; i < n; ++i) {
    for (double& coordinate : x) coordinate = to_unit(rng());
    add(values, g.f(x));
  }
  return mean_of(values);
}

}  // namespace mc
