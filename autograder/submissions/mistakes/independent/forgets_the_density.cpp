// mistake: importance sampling without dividing by the density
// caught by: 2.4 the mean of g over p
// caught by: 2.4 the estimate is unbiased
// caught by: 2.4 the right density
// caught by: 2.4 weights of any size
// hint: this is the mean of g: where p is large, points are many
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
    add(weights, density > 0 && std::isfinite(density) ? g.f({&x, 1}) : 0);
  }
  return mean_of(weights);
}

}  // namespace mc
