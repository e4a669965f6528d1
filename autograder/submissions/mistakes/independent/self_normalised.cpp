// mistake: divides by the sum of the weights 1 / p
// caught by: 2.4 the mean of g over p
// caught by: 2.4 weights of any size
// caught by: 2.4 points without
// caught by: 2.4 the estimate is unbiased
// caught by: 2.4 the right density
// hint: this divides by the sum of the weights 1 / p
#include "independent.hpp"

#define estimate_importance right_estimate_importance
#include "solutions/independent.cpp"
#undef estimate_importance

namespace mc {

Estimate estimate_importance(const Integrand& g, const Density& p, std::uint64_t n, Rng& rng) {
  require_samples(n);
  Moments weights, inverses;
  for (std::uint64_t i = 0; i < n; ++i) {
    const double x = p.sample(to_unit(rng()));
    const double density = p.pdf(x);
    const bool counts = density > 0 && std::isfinite(density);
    add(weights, counts ? g.f({&x, 1}) / density : 0);
    add(inverses, counts ? 1 / density : 0);
  }
  const Estimate all = mean_of(weights);
  return {all.value / inverses.mean, all.standard_error / inverses.mean, n};
}

}  // namespace mc
