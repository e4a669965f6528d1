// Mistakes in task 2.4.
#include "independent.hpp"

#define estimate_importance right_estimate_importance
#include "solutions/independent.cpp"
#undef estimate_importance

namespace mc {
namespace {

bool counts(double density) {
  return density > 0 && std::isfinite(density);
}

/// The mean of n weights, each of a uniform number.
template <class Weight>
Estimate mean_weight(std::uint64_t n, Rng& rng, Weight weight) {
  require_samples(n);
  Moments weights;
  for (std::uint64_t i = 0; i < n; ++i) add(weights, weight(to_unit(rng())));
  return mean_of(weights);
}

}  // namespace
}  // namespace mc

// mistake: clamps weights at 1000 to reduce noise
// hint: weights beyond 1000 are clamped, which makes the estimate biased
namespace mc::clamps_weights {
Estimate estimate_importance(const Integrand& g, const Density& p, std::uint64_t n, Rng& rng) {
  return mean_weight(n, rng, [&](double u) {
    const double x = p.sample(u), density = p.pdf(x);
    return counts(density) ? std::min(g.f({&x, 1}) / density, 1000.0) : 0;
  });
}
}  // namespace mc::clamps_weights

// mistake: evaluates the density at u, not at x
// hint: this divides by p(u): divide by p(x)
namespace mc::density_at_u {
Estimate estimate_importance(const Integrand& g, const Density& p, std::uint64_t n, Rng& rng) {
  return mean_weight(n, rng, [&](double u) {
    const double x = p.sample(u), density = p.pdf(u);
    return counts(density) ? g.f({&x, 1}) / density : 0;
  });
}
}  // namespace mc::density_at_u

// mistake: divides by the density even where it is 0
// hint: where the pdf is 0 or infinite, add 0
namespace mc::divides_by_zero {
Estimate estimate_importance(const Integrand& g, const Density& p, std::uint64_t n, Rng& rng) {
  return mean_weight(n, rng, [&](double u) {
    const double x = p.sample(u);
    return g.f({&x, 1}) / p.pdf(x);
  });
}
}  // namespace mc::divides_by_zero

// mistake: returns the standard error of g, not of g / p
// hint: this is the standard error of g's values
namespace mc::error_of_g {
Estimate estimate_importance(const Integrand& g, const Density& p, std::uint64_t n, Rng& rng) {
  require_samples(n);
  Moments weights, values;
  for (std::uint64_t i = 0; i < n; ++i) {
    const double x = p.sample(to_unit(rng())), density = p.pdf(x);
    const double value = g.f({&x, 1});
    add(weights, counts(density) ? value / density : 0);
    add(values, value);
  }
  return {mean_of(weights).value, mean_of(values).standard_error, n};
}
}  // namespace mc::error_of_g

// mistake: samples by importance without dividing by the density
// hint: this is the mean of g: divide each value by p
namespace mc::forgets_the_density {
Estimate estimate_importance(const Integrand& g, const Density& p, std::uint64_t n, Rng& rng) {
  return mean_weight(n, rng, [&](double u) {
    const double x = p.sample(u);
    return counts(p.pdf(x)) ? g.f({&x, 1}) : 0;
  });
}
}  // namespace mc::forgets_the_density

// mistake: omits points of weight 0 from n
// hint: count every sample, including those of weight 0
namespace mc::only_counts_hits {
Estimate estimate_importance(const Integrand& g, const Density& p, std::uint64_t n, Rng& rng) {
  require_samples(n);
  Moments weights;
  for (std::uint64_t i = 0; i < n; ++i) {
    const double x = p.sample(to_unit(rng())), density = p.pdf(x);
    if (counts(density)) add(weights, g.f({&x, 1}) / density);
  }
  return mean_of(weights);
}
}  // namespace mc::only_counts_hits

// mistake: draws uniform points and weights them as if they had the density
// hint: never called p.sample()
// hint: nothing was returned
namespace mc::samples_uniformly {
Estimate estimate_importance(const Integrand& g, const Density& p, std::uint64_t n, Rng& rng) {
  return mean_weight(n, rng, [&](double u) {
    const double density = p.pdf(u);
    return counts(density) ? g.f({&u, 1}) / density : 0;
  });
}
}  // namespace mc::samples_uniformly

// mistake: divides by the sum of the weights 1 / p
// hint: this divides by the sum of the weights 1 / p
namespace mc::self_normalised {
Estimate estimate_importance(const Integrand& g, const Density& p, std::uint64_t n, Rng& rng) {
  require_samples(n);
  Moments weights, inverses;
  for (std::uint64_t i = 0; i < n; ++i) {
    const double x = p.sample(to_unit(rng())), density = p.pdf(x);
    add(weights, counts(density) ? g.f({&x, 1}) / density : 0);
    add(inverses, counts(density) ? 1 / density : 0);
  }
  const Estimate all = mean_of(weights);
  return {all.value / inverses.mean, all.standard_error / inverses.mean, n};
}
}  // namespace mc::self_normalised

// mistake: treats a density below 1e-10 as 0
// hint: a tiny or huge density is valid
namespace mc::small_density_is_none {
Estimate estimate_importance(const Integrand& g, const Density& p, std::uint64_t n, Rng& rng) {
  return mean_weight(n, rng, [&](double u) {
    const double x = p.sample(u), density = p.pdf(x);
    return density > 1e-10 && counts(density) ? g.f({&x, 1}) / density : 0;
  });
}
}  // namespace mc::small_density_is_none
