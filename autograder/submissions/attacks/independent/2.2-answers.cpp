// Answers that are not sampled, or incomplete. Sections: see CONTRIBUTING.md.

#include <cmath>
#include <stdexcept>

#include "independent.hpp"

namespace mc {

double to_unit(std::uint64_t bits) {
  return static_cast<double>(bits >> 11) * 0x1p-53;
}

}  // namespace mc

//// quadrature
// attack: integrates by the midpoint rule: n evaluations, their mean, and nothing random
// earns: 8
// says: differs from uniform by

#include <vector>

namespace mc {
namespace {

Estimate of(double sum, double squares, double n) {
  const double mean = sum / n;
  return {mean, std::sqrt((squares / n - mean * mean) / (n - 1)), static_cast<std::uint64_t>(n)};
}

}  // namespace

Estimate estimate(const Integrand& g, std::uint64_t n, Rng&) {
  if (n == 0) throw std::invalid_argument("n");
  double sum = 0, squares = 0;
  std::vector<double> x(g.dims);
  for (std::uint64_t i = 0; i < n; ++i) {
    for (std::size_t d = 0; d < g.dims; ++d) {  // Kronecker's lattice, where there are more axes
      const double place = (static_cast<double>(i) + 0.5) / static_cast<double>(n);
      const double at =
          d == 0 ? place : static_cast<double>(i) * std::sqrt(1.0 + static_cast<double>(d));
      x[d] = at - std::floor(at);
    }
    const double value = g.f(x);
    sum += value;
    squares += value * value;
  }
  return of(sum, squares, static_cast<double>(n));
}

Estimate estimate_importance(const Integrand& g, const Density& p, std::uint64_t n, Rng&) {
  if (n == 0) throw std::invalid_argument("n");
  double sum = 0, squares = 0;
  for (std::uint64_t i = 0; i < n; ++i) {
    const double x = p.sample((static_cast<double>(i) + 0.5) / static_cast<double>(n));
    const double density = p.pdf(x);
    const double weight = density > 0 && std::isfinite(density) ? g.f({&x, 1}) / density : 0;
    sum += weight;
    squares += weight * weight;
  }
  return of(sum, squares, static_cast<double>(n));
}
}  // namespace mc
