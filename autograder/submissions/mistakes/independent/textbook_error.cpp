// mistake: the standard error comes from E{X^2} - E{X}^2, which loses its digits far from 0
// caught by: 2.2 the standard error
// caught by: 2.2 a constant
// hint: this comes from variance_textbook()
#include "independent.hpp"

#define estimate right_estimate
#include "solutions/independent.cpp"
#undef estimate

namespace mc {

Estimate estimate(const Integrand& g, std::uint64_t n, Rng& rng) {
  require_samples(n);
  std::vector<double> x(g.dims), values;
  for (std::uint64_t i = 0; i < n; ++i) {
    for (double& coordinate : x) coordinate = to_unit(rng());
    values.push_back(g.f(x));
  }
  return {mean(values), std::sqrt(variance_textbook(values) / static_cast<double>(n)), n};
}

}  // namespace mc
