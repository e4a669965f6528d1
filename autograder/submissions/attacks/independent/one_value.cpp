// attack: evaluates g once, and says that it was n times
// earns: 8
// says: gave 1 values in points
#include "independent.hpp"

#include <cmath>
#include <stdexcept>
#include <vector>

#include "common/todo.hpp"

namespace mc {
double to_unit(std::uint64_t bits) {
  return static_cast<double>(bits >> 11) * 0x1p-53;
}

Estimate estimate(const Integrand& g, std::uint64_t n, Rng& rng) {
  if (n == 0) throw std::invalid_argument("n");
  std::vector<double> x(g.dims);
  for (double& coordinate : x) coordinate = to_unit(rng());
  return {g.f(x), n == 1 ? std::nan("") : 0, n};
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

Estimate estimate_importance(const Integrand& g, const Density& p, std::uint64_t n, Rng& rng) {
  if (n == 0) throw std::invalid_argument("n");
  const double x = p.sample(to_unit(rng()));
  return {g.f({&x, 1}) / p.pdf(x), n == 1 ? std::nan("") : 0, n};
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
