// mistake: coordinates are made as floats: 24 bits
// caught by: 2.2 the points are uniform
// hint: with all of its 53 bits
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
    for (double& coordinate : x) coordinate = static_cast<float>(rng() >> 40) * 0x1p-24f;
    add(values, g.f(x));
  }
  return mean_of(values);
}

}  // namespace mc
