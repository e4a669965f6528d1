// mistake: the standard error is that of g, not of g / p
// caught by: 2.4 the mean of g over p
// caught by: 2.4 weights of any size
// caught by: 2.4 points without
// caught by: 2.4 the right density
// hint: this is the standard error of g's values
#include "independent.hpp"

#define estimate_importance right_estimate_importance
#include "solutions/independent.cpp"
#undef estimate_importance

namespace mc {

Estimate estimate_importance(const Integrand& g, const Density& p, std::uint64_t n, Rng& rng) {
  require_samples(n);
  Moments weights, values;
  for (std::uint64_t i = 0; i < n; ++i) {
    const double x = p.sample(to_unit(rng()));
    const double density = p.pdf(x);
    const bool counts = density > 0 && std::isfinite(density);
    const double value = g.f({&x, 1});
    add(weights, counts ? value / density : 0);
    add(values, value);
  }
  return {mean_of(weights).value, mean_of(values).standard_error, n};
}

}  // namespace mc
