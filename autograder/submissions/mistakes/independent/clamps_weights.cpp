// mistake: cuts off weights beyond 1000, against the noise
// caught by: 2.4 weights of any size
// hint: weights beyond 1000 are cut off
#include "independent.hpp"

#define estimate_importance right_estimate_importance
#include "solutions/independent.cpp"
#undef estimate_importance

namespace mc {

Estimate estimate_importance(const Integrand& g, const Density& p, std::uint64_t n, Rng& rng) {
  require_samples(n);
  Moments weights;
  for (std::uint64_t i = 0; i < n; ++i) {
    const double x = p.sample(to_unit(rng()));
    const double density = p.pdf(x);
    const bool counts = density > 0 && std::isfinite(density);
    add(weights, counts ? std::min(g.f({&x, 1}) / density, 1000.0) : 0);
  }
  return mean_of(weights);
}

}  // namespace mc
