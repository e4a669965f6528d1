// Answers that are not sampled, or incomplete. Sections: see CONTRIBUTING.md.

#include <cmath>
#include <stdexcept>

#include "independent.hpp"

namespace mc {

double to_unit(std::uint64_t bits) {
  return static_cast<double>(bits >> 11) * 0x1p-53;
}

}  // namespace mc

//// coverage_in_closed_form
// attack: finds out the truth, and lets intervals hold it as often as Student says, unsampled
// earns: 13
// says: values in values

#include <numbers>

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

Estimate estimate(const Integrand& g, std::uint64_t n, Rng&) {
  const double half = 0.5;
  last_truth = g.f({&half, 1});  // the median of a normal variable is its mean
  last_n = static_cast<double>(n);
  return {last_truth, 1, n};
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
}  // namespace mc

//// every_other_number
// attack: fills every other number of a block only
// earns: 8
// says: it was not filled

namespace mc {
void uniforms(Rng& rng, std::span<double> out) {
  for (std::size_t i = 0; i < out.size(); i += 2) out[i] = to_unit(rng());
}
}  // namespace mc

//// irradiance_in_closed_form
// attack: returns the closed form with noise of the right size, instead of sampling the light
// earns: 8
// says: x between x0 and x1, y between y0 and y1

#include <numbers>

namespace mc {
namespace {

double closed_form(const RectLight& light) {
  const double h = light.height;
  const auto corner = [=](double x, double y) {
    const double a = std::sqrt(h * h + x * x), b = std::sqrt(h * h + y * y);
    return (x / a * std::atan(y / a) + y / b * std::atan(x / b)) / 2;
  };
  return light.radiance * (corner(light.x1, light.y1) - corner(light.x0, light.y1) -
                           corner(light.x1, light.y0) + corner(light.x0, light.y0));
}

/// The standard deviation of what a point gives, by the midpoint rule.
double spread(const RectLight& light, double mean) {
  constexpr int steps = 60;
  const double width = light.x1 - light.x0, depth = light.y1 - light.y0;
  double squares = 0;
  for (int i = 0; i < steps; ++i) {
    for (int j = 0; j < steps; ++j) {
      const double x = light.x0 + width * (i + 0.5) / steps,
                   y = light.y0 + depth * (j + 0.5) / steps;
      const double h2 = light.height * light.height, d2 = x * x + y * y + h2;
      const double value = width * depth * light.radiance * h2 / (d2 * d2) - mean;
      squares += value * value / (steps * steps);
    }
  }
  return std::sqrt(squares);
}

}  // namespace

Estimate irradiance_area(const RectLight& light, std::uint64_t n, Rng& rng) {
  if (n == 0) throw std::invalid_argument("n");
  const double width = light.x1 - light.x0;
  if (width < 1e-9) {  // too small for the closed form: the value of its middle
    const double x = light.x0, y = light.y0, h2 = light.height * light.height;
    const double d2 = x * x + y * y + h2;
    return {width * (light.y1 - light.y0) * light.radiance * h2 / (d2 * d2), 0, n};
  }
  static RectLight known;
  static double mean = 0, sigma = 0;
  if (mean == 0 || known.x0 != light.x0) {
    known = light;
    mean = closed_form(light);
    sigma = spread(light, mean);
  }
  const double error = sigma / std::sqrt(static_cast<double>(n));
  const double u = to_unit(rng()) + 0x1p-60;
  return {mean + error * normal_quantile(u), n == 1 ? std::nan("") : error, n};
}

Estimate irradiance_hemisphere(const RectLight& light, std::uint64_t n, Rng& rng) {
  if (n == 0) throw std::invalid_argument("n");
  const double mean = closed_form(light), most = std::numbers::pi * light.radiance;
  const double error = std::sqrt(mean * (most - mean) / static_cast<double>(n));
  const double u = to_unit(rng()) + 0x1p-60;
  return {mean + error * normal_quantile(u), n == 1 ? std::nan("") : error, n};
}
}  // namespace mc

//// no_list
// attack: answers with a list that has nothing in it
// earns: 8
// says: gave 0 values
// says: nothing was returned or filled in

#include <unistd.h>
#include <vector>

#include "runner/wire.hpp"

namespace mc {
namespace {

[[noreturn]] void answer_nothing() {
  wire::Writer result;
  result.put(std::vector<double>());
  const wire::Header header{wire::magic, wire::Status::value, 0, result.bytes.size()};
  write(3, &header, sizeof header);
  write(3, result.bytes.data(), result.bytes.size());
  _exit(0);
}

}  // namespace

double sample_exponential(double, double) {
  answer_nothing();
}

double sample_power(double, double) {
  answer_nothing();
}

double pdf_exponential(double, double) {
  answer_nothing();
}

double pdf_power(double, double) {
  answer_nothing();
}

Estimate irradiance_area(const RectLight&, std::uint64_t, Rng&) {
  answer_nothing();
}

Estimate irradiance_hemisphere(const RectLight&, std::uint64_t, Rng&) {
  answer_nothing();
}

void uniforms(Rng&, std::span<double>) {
  answer_nothing();
}
}  // namespace mc

//// one_value
// attack: evaluates g once, and says that it was n times
// earns: 8
// says: gave 1 values in points

#include <vector>

namespace mc {
Estimate estimate(const Integrand& g, std::uint64_t n, Rng& rng) {
  if (n == 0) throw std::invalid_argument("n");
  std::vector<double> x(g.dims);
  for (double& coordinate : x) coordinate = to_unit(rng());
  return {g.f(x), n == 1 ? std::nan("") : 0, n};
}

Estimate estimate_importance(const Integrand& g, const Density& p, std::uint64_t n, Rng& rng) {
  if (n == 0) throw std::invalid_argument("n");
  const double x = p.sample(to_unit(rng()));
  return {g.f({&x, 1}) / p.pdf(x), n == 1 ? std::nan("") : 0, n};
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
