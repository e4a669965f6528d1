// Lab 2 · independent sampling. labs/2-independent/independent.hpp states what each function
// promises, and labs/2-independent/README.md is the handout. Use your own functions of lab 1. Write
// the tasks in any order and check them with
//
//   ./lab check independent              the whole lab
//   ./lab check independent --only 2.1   one task

#include "independent.hpp"

#include <stdexcept>

#include "common/todo.hpp"

namespace mc {

/// A finished example: the density at x of the uniform distribution on [low, high).
[[maybe_unused]] static double pdf_uniform(double x, double low, double high) {
  if (!(low < high)) {  // also true if one of them is NaN
    throw std::invalid_argument("low: must be less than high");
  }
  return x >= low && x < high ? 1 / (high - low) : 0;
}

double to_unit(std::uint64_t bits) {
  throw todo("2.1");  // TODO(2.1): 53 bits fit into a double without rounding; 64 do not
}

Estimate estimate(const Integrand& g, std::uint64_t n, Rng& rng) {
  throw todo("2.2");  // TODO(2.2): n points, n values, their mean, and s / sqrt(n)
}

double sample_exponential(double u, double rate) {
  throw todo("2.3");  // TODO(2.3): solve P(x) = u for x; std::log1p keeps the digits of a small u
}

double sample_power(double u, double a) {
  throw todo("2.3");  // TODO(2.3): the same for P(x) = x^(a+1)
}

double pdf_exponential(double x, double rate) {
  throw todo("2.3");  // TODO(2.3): the derivative of P, and 0 outside the support
}

double pdf_power(double x, double a) {
  throw todo("2.3");  // TODO(2.3): the same
}

Estimate estimate_importance(const Integrand& g, const Density& p, std::uint64_t n, Rng& rng) {
  throw todo("2.4");  // TODO(2.4): x = p.sample(u), and the mean of g(x) / p(x)
}

Interval confidence_interval(const Estimate& estimate, double level) {
  throw todo("2.5");  // TODO(2.5): the value, and z standard errors to either side
}

std::uint64_t samples_for(const Estimate& pilot, double target_error) {
  throw todo("2.6");  // TODO(2.6): n (standard error / target)^2, rounded up
}

Estimate irradiance_area(const RectLight& light, std::uint64_t n, Rng& rng) {
  throw todo("2.7");  // TODO(2.7): area * radiance * cos * cos / distance^2 at a point of the light
}

Estimate irradiance_hemisphere(const RectLight& light, std::uint64_t n, Rng& rng) {
  throw todo("2.7");  // TODO(2.7): pi * radiance if a direction hits the light, else 0
}

void uniforms(Rng& rng, std::span<double> out) {
  throw todo("2.8");  // TODO(2.8): stretch, the speed task; a loop over to_unit(rng()) is correct
}

Estimate irradiance_combined(const RectLight& light, std::uint64_t n, Rng& rng) {
  throw todo("2.9");  // TODO(2.9): stretch; f / (p_area + p_hemisphere) at a point and a direction
}

}  // namespace mc
