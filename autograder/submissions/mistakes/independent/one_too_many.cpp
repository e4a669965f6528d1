// mistake: the loop runs to n inclusive: n + 1 evaluations, over n
// caught by: 2.2 exactly n evaluations
// caught by: 2.2 one sample
// caught by: 2.2 rare events
// hint: one too many: does the loop end at i <= n?
#include "independent.hpp"

#define estimate right_estimate
#include "solutions/independent.cpp"
#undef estimate

namespace mc {

Estimate estimate(const Integrand& g, std::uint64_t n, Rng& rng) {
  require_samples(n);
  std::vector<double> x(g.dims);
  Moments values;
  for (std::uint64_t i = 0; i <= n; ++i) {
    for (double& coordinate : x) coordinate = to_unit(rng());
    add(values, g.f(x));
  }
  return mean_of(values);
}

}  // namespace mc
