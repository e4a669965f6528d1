// mistake: asks for the density at u, not at x
// caught by: 2.4 the mean of g over p
// caught by: 2.4 weights of any size
// caught by: 2.4 the estimate is unbiased
// caught by: 2.4 the right density
// hint: this divides by p at u: the density belongs to x
#include "independent.hpp"

#define estimate_importance right_estimate_importance
#include "solutions/independent.cpp"
#undef estimate_importance

namespace mc {

Estimate estimate_importance(const Integrand& g, const Density& p, std::uint64_t n, Rng& rng) {
  require_samples(n);
  Moments weights;
  for (std::uint64_t i = 0; i < n; ++i) {
    const double u = to_unit(rng()), x = p.sample(u);
    const double density = p.pdf(u);
    const bool counts = density > 0 && std::isfinite(density);
    add(weights, counts ? g.f({&x, 1}) / density : 0);
  }
  return mean_of(weights);
}

}  // namespace mc
