// mistake: divides by the density whatever it is
// caught by: 2.4 points without
// hint: where the pdf is 0 or infinite, add 0
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
    add(weights, g.f({&x, 1}) / p.pdf(x));
  }
  return mean_of(weights);
}

}  // namespace mc
