// Attacks on all tasks of the lab. Sections: see CONTRIBUTING.md.

//// odd_numbers
// attack: answers with NaN, infinities, 1 and 1e300 wherever a number is asked for
// says: = 1e+300
#include "independent.hpp"

#include <cmath>
#include <vector>

#include "common/todo.hpp"

namespace mc {
namespace {

double odd() {
  static int next = 0;
  const double numbers[] = {1e300, std::nan(""), 1, -0.0, HUGE_VAL, -HUGE_VAL, -1, 5e-324, 0.5};
  return numbers[next++ % 9];
}
Estimate odd_estimate(std::uint64_t n) {
  const double value = odd();
  return {value, odd(), n};
}

}  // namespace

double to_unit(std::uint64_t) {
  return odd();
}

Estimate estimate(const Integrand& g, std::uint64_t n, Rng&) {
  std::vector<double> x(g.dims);
  for (std::uint64_t i = 0; i < n; ++i) {
    for (double& coordinate : x) coordinate = odd();
    g.f(x);
  }
  return odd_estimate(n);
}

double sample_exponential(double, double) {
  return odd();
}

double sample_power(double, double) {
  return odd();
}

double pdf_exponential(double, double) {
  return odd();
}

double pdf_power(double, double) {
  return odd();
}

Estimate estimate_importance(const Integrand& g, const Density& p, std::uint64_t n, Rng&) {
  for (std::uint64_t i = 0; i < n; ++i) {
    const double x = p.sample(odd());
    g.f({&x, 1});
  }
  return odd_estimate(n);
}

Interval confidence_interval(const Estimate&, double) {
  const double low = odd();
  return {low, odd()};
}

std::uint64_t samples_for(const Estimate&, double) {
  return ~std::uint64_t{0};
}

Estimate irradiance_area(const RectLight&, std::uint64_t n, Rng&) {
  return odd_estimate(n);
}

Estimate irradiance_hemisphere(const RectLight&, std::uint64_t n, Rng&) {
  return odd_estimate(n);
}

void uniforms(Rng&, std::span<double> out) {
  for (double& u : out) u = odd();
}

}  // namespace mc

//// returns_zero
// attack: returns zero from every function: a check must not be content with what costs nothing
// says: an integer divided by an integer is an integer: 0
#include "independent.hpp"
namespace mc {
double to_unit(std::uint64_t) {
  return 0;
}
Estimate estimate(const Integrand&, std::uint64_t, Rng&) {
  return {};
}
double sample_exponential(double, double) {
  return 0;
}
double sample_power(double, double) {
  return 0;
}
double pdf_exponential(double, double) {
  return 0;
}
double pdf_power(double, double) {
  return 0;
}
Estimate estimate_importance(const Integrand&, const Density&, std::uint64_t, Rng&) {
  return {};
}
Interval confidence_interval(const Estimate&, double) {
  return {};
}
std::uint64_t samples_for(const Estimate&, double) {
  return 0;
}
Estimate irradiance_area(const RectLight&, std::uint64_t, Rng&) {
  return {};
}
Estimate irradiance_hemisphere(const RectLight&, std::uint64_t, Rng&) {
  return {};
}
void uniforms(Rng&, std::span<double> out) {
  for (double& u : out) u = 0;
}
}  // namespace mc
