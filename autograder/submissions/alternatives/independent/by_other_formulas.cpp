// alternative: logarithms for powers, ldexp for products, the upper quantile, a direction from its
// cosine, weights of the balance heuristic by densities per area
#include "independent.hpp"

#define to_unit right_to_unit
#define sample_exponential right_sample_exponential
#define sample_power right_sample_power
#define pdf_power right_pdf_power
#define confidence_interval right_confidence_interval
#define samples_for right_samples_for
#define irradiance_hemisphere right_irradiance_hemisphere
#define irradiance_combined right_irradiance_combined
#include "solutions/independent.cpp"

#include <cmath>
#undef to_unit
#undef sample_exponential
#undef sample_power
#undef pdf_power
#undef confidence_interval
#undef samples_for
#undef irradiance_hemisphere
#undef irradiance_combined

namespace mc {

double to_unit(std::uint64_t bits) {
  return std::ldexp(static_cast<double>(bits / 2048), -53);
}

double sample_exponential(double u, double rate) {
  require_rate(rate);
  return std::log1p(u / (1 - u)) / rate;  // 1 / (1 - u) = 1 + u / (1 - u)
}

double sample_power(double u, double a) {
  require_power(a);
  return std::exp(std::log(u) / (a + 1));
}

double pdf_power(double x, double a) {
  require_power(a);
  if (x < 0 || x > 1) return 0;
  return a == 0 ? 1 : std::exp(a * std::log(x)) * (a + 1);
}

Interval confidence_interval(const Estimate& estimate, double level) {
  if (!(level > 0 && level < 1)) throw std::invalid_argument("the level must lie inside (0, 1)");
  const double z = normal_quantile(0.5 + level / 2);
  return {estimate.value - z * estimate.standard_error,
          estimate.value + z * estimate.standard_error};
}

std::uint64_t samples_for(const Estimate& pilot, double target_error) {
  if (std::isnan(target_error) || target_error <= 0) {
    throw std::invalid_argument("target_error must be positive");
  }
  const double sigma = pilot.standard_error * std::sqrt(static_cast<double>(pilot.n));
  if (pilot.n < 1 || std::isnan(sigma)) throw std::invalid_argument("the pilot has no error");
  const double samples = sigma / target_error * (sigma / target_error);
  if (samples >= 1.8e19) throw std::invalid_argument("more samples than 64 bits can count");
  return samples < 1 ? 1 : static_cast<std::uint64_t>(std::ceil(samples));
}

Estimate irradiance_hemisphere(const RectLight& light, std::uint64_t n, Rng& rng) {
  require_samples(n);
  std::uint64_t met = 0;
  for (std::uint64_t i = 0; i < n; ++i) {
    const double angle = 2 * std::numbers::pi * to_unit(rng());
    const double cosine = std::sqrt(1 - to_unit(rng())), sine = std::sqrt(1 - cosine * cosine);
    const double x = light.height * sine / cosine * std::sin(angle);
    const double y = light.height * sine / cosine * std::cos(angle);
    met += x > light.x0 && x < light.x1 && y > light.y0 && y < light.y1 ? 1 : 0;
  }
  // All values are 0 or pi L: their mean and variance follow from how many are not 0.
  const auto size = static_cast<double>(n);
  const double share = static_cast<double>(met) / size, each = std::numbers::pi * light.radiance;
  return {each * share, each * std::sqrt(share * (1 - share) / (size - 1)), n};
}

Estimate irradiance_combined(const RectLight& light, std::uint64_t n, Rng& rng) {
  require_samples(n);
  const double by_area = 1 / area(light);
  Moments pairs;
  for (std::uint64_t i = 0; i < n; ++i) {
    const Point2 met = met_by_direction(light.height, rng), on = point_on(light, rng);
    double pair = 0;
    const auto add_term = [&](Point2 at, double density_of_this, double density_of_other) {
      const double distance2 = distance_squared(light, at);
      const double cosines = light.height * light.height / distance2;
      const double f = light.radiance * cosines / distance2;
      pair += density_of_this / (density_of_this + density_of_other) * f / density_of_this;
    };
    const auto by_hemisphere = [&](Point2 at) {
      const double distance2 = distance_squared(light, at);
      return light.height / distance2 * (light.height / distance2) / std::numbers::pi;
    };
    add_term(on, by_area, by_hemisphere(on));
    if (contains(light, met)) add_term(met, by_hemisphere(met), by_area);
    add(pairs, pair);
  }
  return mean_of(pairs);
}

}  // namespace mc
