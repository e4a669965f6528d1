// attack: fills every other number of a block and leaves the rest as it is
// earns: 8
// says: it was not filled
#include "independent.hpp"

#include <cmath>

#include "common/todo.hpp"

namespace mc {
double to_unit(std::uint64_t bits) {
  return static_cast<double>(bits >> 11) * 0x1p-53;
}

Estimate estimate(const Integrand&, std::uint64_t, Rng&) {
  throw todo("2.2");
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

Estimate estimate_importance(const Integrand&, const Density&, std::uint64_t, Rng&) {
  throw todo("2.4");
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

void uniforms(Rng& rng, std::span<double> out) {
  for (std::size_t i = 0; i < out.size(); i += 2) out[i] = to_unit(rng());
}

}  // namespace mc
