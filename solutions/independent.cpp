// Lab 2 · independent sampling: the reference solution. The speed task has its definition first,
// then a faster version with the reason why it is faster.

#include "independent.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <vector>

#include "common/points.hpp"

namespace mc {
namespace {

void require_samples(std::uint64_t n) {
  if (n == 0) throw std::invalid_argument("n: an estimate needs at least one sample");
}

/// The estimate of an expectation from n values: their mean, and its standard error.
Estimate mean_of(const Moments& values) {
  const double error = std::sqrt(variance(values) / static_cast<double>(values.count));
  return {values.mean, error, values.count};
}

}  // namespace

// 2.1 ---------------------------------------------------------------------------------------------

double to_unit(std::uint64_t bits) {
  return static_cast<double>(bits >> 11) * 0x1p-53;  // 53 bits are exact; 64 would round up to 1
}

// 2.2 ---------------------------------------------------------------------------------------------

Estimate estimate(const Integrand& g, std::uint64_t n, Rng& rng) {
  require_samples(n);
  std::vector<double> x(g.dims);
  Moments values;
  for (std::uint64_t i = 0; i < n; ++i) {
    for (double& coordinate : x) coordinate = to_unit(rng());
    add(values, g.f(x));
  }
  return mean_of(values);
}

// 2.3 ---------------------------------------------------------------------------------------------

namespace {

void require_rate(double rate) {
  if (!(rate > 0)) throw std::invalid_argument("rate: must be positive");  // also refuses NaN
}

void require_power(double a) {
  if (!(a > -1)) throw std::invalid_argument("a: x^a has no finite integral unless a > -1");
}

}  // namespace

double sample_exponential(double u, double rate) {
  require_rate(rate);
  return -std::log1p(-u) / rate;  // P(x) = 1 - exp(-rate x)
}

double sample_power(double u, double a) {
  require_power(a);
  return std::pow(u, 1 / (a + 1));  // P(x) = x^(a+1)
}

double pdf_exponential(double x, double rate) {
  require_rate(rate);
  return x < 0 ? 0 : rate * std::exp(-rate * x);
}

double pdf_power(double x, double a) {
  require_power(a);
  return x < 0 || x > 1 ? 0 : (a + 1) * std::pow(x, a);
}

// 2.4 ---------------------------------------------------------------------------------------------

Estimate estimate_importance(const Integrand& g, const Density& p, std::uint64_t n, Rng& rng) {
  require_samples(n);
  Moments weights;
  for (std::uint64_t i = 0; i < n; ++i) {
    const double x = p.sample(to_unit(rng()));
    const double density = p.pdf(x);
    const bool counts = density > 0 && std::isfinite(density);
    add(weights, counts ? g.f({&x, 1}) / density : 0);
  }
  return mean_of(weights);
}

// 2.5 ---------------------------------------------------------------------------------------------

Interval confidence_interval(const Estimate& estimate, double level) {
  if (!(level > 0 && level < 1)) throw std::invalid_argument("level: must lie inside (0, 1)");
  const double tail = (1 - level) / 2;  // the probability below the interval, and above it
  const double half_width = -normal_quantile(tail) * estimate.standard_error;
  return {estimate.value - half_width, estimate.value + half_width};
}

// 2.6 ---------------------------------------------------------------------------------------------

std::uint64_t samples_for(const Estimate& pilot, double target_error) {
  if (!(target_error > 0)) throw std::invalid_argument("target_error: must be positive");
  if (pilot.n == 0 || std::isnan(pilot.standard_error)) {
    throw std::invalid_argument("pilot: its standard error is unknown");
  }
  const double ratio = pilot.standard_error / target_error;
  const double n = std::ceil(static_cast<double>(pilot.n) * ratio * ratio);
  if (!(n < 0x1p64)) throw std::invalid_argument("target_error: would take 2^64 samples or more");
  return std::max<std::uint64_t>(1, static_cast<std::uint64_t>(n));
}

// 2.7 ---------------------------------------------------------------------------------------------

namespace {

Point2 point_on(const RectLight& light, Rng& rng) {
  const double x = light.x0 + (light.x1 - light.x0) * to_unit(rng());
  return {x, light.y0 + (light.y1 - light.y0) * to_unit(rng())};
}

/// Where a random direction with density cos / pi meets the plane at this height. The direction is
/// a uniform point of the unit disk, projected up to the hemisphere (Malley).
Point2 met_by_direction(double height, Rng& rng) {
  const double u = to_unit(rng());
  const double radius = std::sqrt(u), angle = 2 * std::numbers::pi * to_unit(rng());
  const double scale = height / std::sqrt(1 - u);  // to the plane
  return {radius * std::cos(angle) * scale, radius * std::sin(angle) * scale};
}

double area(const RectLight& light) {
  return (light.x1 - light.x0) * (light.y1 - light.y0);
}

bool contains(const RectLight& light, Point2 at) {
  return light.x0 <= at.x && at.x <= light.x1 && light.y0 <= at.y && at.y <= light.y1;
}

double distance_squared(const RectLight& light, Point2 at) {
  return at.x * at.x + at.y * at.y + light.height * light.height;
}

}  // namespace

Estimate irradiance_area(const RectLight& light, std::uint64_t n, Rng& rng) {
  require_samples(n);
  Moments values;
  for (std::uint64_t i = 0; i < n; ++i) {
    const double distance2 = distance_squared(light, point_on(light, rng));
    const double cosines = light.height * light.height / distance2;  // equal at both ends
    add(values, area(light) * light.radiance * cosines / distance2);
  }
  return mean_of(values);
}

Estimate irradiance_hemisphere(const RectLight& light, std::uint64_t n, Rng& rng) {
  require_samples(n);
  Moments values;
  for (std::uint64_t i = 0; i < n; ++i) {
    const bool meets = contains(light, met_by_direction(light.height, rng));
    add(values, meets ? std::numbers::pi * light.radiance : 0);
  }
  return mean_of(values);
}

// 2.8 ---------------------------------------------------------------------------------------------

namespace definition {
void uniforms(Rng& rng, std::span<double> out) {
  for (double& u : out) u = to_unit(rng());
}
}  // namespace definition

// Before AVX-512, vector units can neither multiply 64-bit words, as the generator does, nor
// convert them to double. Both can be avoided:
//
// * xoshiro256+ (Blackman, Vigna 2021, "Scrambled linear pseudorandom number generators") needs
//   only additions, shifts, rotations and XORs; it is designed for generators of doubles, which use
//   the upper 53 bits. Sixteen of them run in parallel, each from its own 256 random bits: four
//   lanes fill a register, and the four registers do not wait for each other.
// * A word becomes a double by writing its bits into the mantissas of two powers of two: the upper
//   21 next to 2^31, whose last place is 2^-21, the lower 32 next to 1/2, whose last place is
//   2^-53. Subtracting the powers is exact.

namespace {

constexpr std::size_t lanes = 16;

/// floor(bits / 2^11) 2^-53, without a conversion from integer to double.
double to_unit_by_mantissa(std::uint64_t bits) {
  const std::uint64_t upper = bits >> 43, lower = (bits >> 11) & 0xffffffffu;
  return (std::bit_cast<double>(std::bit_cast<std::uint64_t>(0x1p31) | upper) - (0x1p31 + 0.5)) +
         std::bit_cast<double>(std::bit_cast<std::uint64_t>(0.5) | lower);
}

}  // namespace

void uniforms(Rng& rng, std::span<double> out) {
  std::size_t i = 0;
  if (out.size() >= 8 * lanes) {  // for fewer numbers, seeding costs more than it saves
    std::array<std::uint64_t, lanes> a, b, c, d;
    for (auto* const word : {&a, &b, &c, &d}) {
      for (std::uint64_t& seed : *word) seed = rng();
    }
    for (; i + lanes <= out.size(); i += lanes) {
      double* const next = out.data() + i;  // a span may check every index
      for (std::size_t lane = 0; lane < lanes; ++lane) {
        next[lane] = to_unit_by_mantissa(a[lane] + d[lane]);
        const std::uint64_t shifted = b[lane] << 17;
        c[lane] ^= a[lane];
        d[lane] ^= b[lane];
        b[lane] ^= c[lane];
        a[lane] ^= d[lane];
        c[lane] ^= shifted;
        d[lane] = std::rotl(d[lane], 45);
      }
    }
  }
  // The last numbers of a long span, or all numbers of a short one: first all words, then all
  // doubles, so that both loops can use vector registers. The generator is a counter, so its words
  // do not wait for each other. Vector units replace a 64-bit product by three 32-bit ones; for few
  // numbers that costs less than seeding the lanes.
  std::uint64_t words[8 * lanes];
  double* const rest = out.data() + i;
  const std::size_t count = out.size() - i;
  for (std::size_t k = 0; k < count; ++k) words[k] = rng();
  for (std::size_t k = 0; k < count; ++k) rest[k] = to_unit_by_mantissa(words[k]);
}

// 2.9 ---------------------------------------------------------------------------------------------

Estimate irradiance_combined(const RectLight& light, std::uint64_t n, Rng& rng) {
  require_samples(n);
  // f / (p_area + p_hemisphere) for the direction to a point of the light. Both densities are per
  // solid angle: the area dA at this point covers cos(light) dA / distance^2.
  const auto balanced = [&](Point2 at) {
    const double distance2 = distance_squared(light, at);
    const double cosine = light.height / std::sqrt(distance2);  // equal at both ends
    const double p_area = distance2 / (cosine * area(light));
    const double p_hemisphere = cosine / std::numbers::pi;
    return light.radiance * cosine / (p_area + p_hemisphere);
  };
  Moments pairs;
  for (std::uint64_t i = 0; i < n; ++i) {
    const double by_point = balanced(point_on(light, rng));
    const Point2 met = met_by_direction(light.height, rng);
    add(pairs, by_point + (contains(light, met) ? balanced(met) : 0));
  }
  return mean_of(pairs);
}

}  // namespace mc
