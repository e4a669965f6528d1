// attack: integrates by the midpoint rule: n evaluations, their mean, and nothing random
// earns: 8
// says: away from uniform
#include "independent.hpp"

#include <cmath>
#include <stdexcept>
#include <vector>

#include "common/todo.hpp"

namespace mc {
namespace {

Estimate of(double sum, double squares, double n) {
  const double mean = sum / n;
  return {mean, std::sqrt((squares / n - mean * mean) / (n - 1)), static_cast<std::uint64_t>(n)};
}

}  // namespace

double to_unit(std::uint64_t bits) {
  return static_cast<double>(bits >> 11) * 0x1p-53;
}

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

double sample_exponential(double, double) {
  throw todo("2.3");
}

double sample_power(double, double) {
  throw todo("2.3");
}

double pdf_exponential(double, double) {
  throw todo("2.3");
}

double pdf_power(double, double) {
  throw todo("2.3");
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

Interval confidence_interval(const Estimate&, double) {
  throw todo("2.5");
}

std::uint64_t samples_for(const Estimate&, double) {
  throw todo("2.6");
}

Estimate irradiance_area(const RectLight&, std::uint64_t, Rng&) {
  throw todo("2.7");
}

Estimate irradiance_hemisphere(const RectLight&, std::uint64_t, Rng&) {
  throw todo("2.7");
}

void uniforms(Rng&, std::span<double>) {
  throw todo("2.8");
}

}  // namespace mc
