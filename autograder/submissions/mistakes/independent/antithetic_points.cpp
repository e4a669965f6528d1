// mistake: every second point is the mirror image of the one before it: not independent
// caught by: 2.2 the points are uniform
// caught by: 2.2 the estimate is unbiased
// hint: neither a copy nor a mirror image of another
#include "independent.hpp"

#define estimate right_estimate
#include "solutions/independent.cpp"
#undef estimate

namespace mc {

Estimate estimate(const Integrand& g, std::uint64_t n, Rng& rng) {
  require_samples(n);
  std::vector<double> x(g.dims);
  Moments values;
  for (std::uint64_t i = 0; i < n; ++i) {
    for (double& coordinate : x)
      coordinate = i % 2 == 0 ? to_unit(rng()) : 1 - 0x1p-53 - coordinate;
    add(values, g.f(x));
  }
  return mean_of(values);
}

}  // namespace mc
