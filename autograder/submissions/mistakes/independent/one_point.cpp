// mistake: the point is drawn once, before the loop
// caught by: 2.2 the estimate is the mean
// caught by: 2.2 exactly n
// caught by: 2.2 the standard error
// caught by: 2.2 a constant
// caught by: 2.2 the points are uniform
// caught by: 2.2 the estimate is unbiased
// caught by: 2.2 the error falls
// caught by: 2.2 rare events
// hint: take new numbers from rng inside the loop
#include "independent.hpp"

#define estimate right_estimate
#include "solutions/independent.cpp"
#undef estimate

namespace mc {

Estimate estimate(const Integrand& g, std::uint64_t n, Rng& rng) {
  require_samples(n);
  std::vector<double> x(g.dims);
  for (double& coordinate : x) coordinate = to_unit(rng());
  Moments values;
  for (std::uint64_t i = 0; i < n; ++i) add(values, g.f(x));
  return mean_of(values);
}

}  // namespace mc
