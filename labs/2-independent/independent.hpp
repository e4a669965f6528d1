#pragma once
// Lab 2 · independent sampling: what you implement in starter/independent.cpp. The handout is
// README.md in this folder.
//
// G_N = 1/N sum g(x_i) with independent x_i is unbiased, has the variance sigma^2 / N, and can
// estimate that variance itself. You may call the functions of lab 1. Throughout:
//
// * Undefined results are a quiet NaN. Misuse throws std::invalid_argument with a message that
//   names the argument. A function without a `throws:` line never throws.
// * Random numbers come from the generator that is passed in, in any order, and from nowhere else;
//   it advances, so that the next call uses different numbers.
// * A function without a `cost:` line takes constant time per number, or time linear in n.

#include <cstdint>
#include <span>

#include "common/estimation.hpp"
#include "common/normal_quantile.hpp"
#include "common/rect_light.hpp"
#include "common/rng.hpp"
#include "variance.hpp"

namespace mc {

/// 2.1  The number in [0, 1) given by the upper 53 bits of a word: floor(bits / 2^11) 2^-53,
/// exactly. Never 1.
/// requires: any word.
/// source: Goualard 2020, "Generating random floating-point numbers by dividing integers".
double to_unit(std::uint64_t bits);

/// 2.2  The integral of `g` over the unit cube, as the mean of g at `n` independent uniform points.
/// Evaluates g exactly n times. standard_error is s / sqrt(n), s^2 the sample variance of the
/// values; NaN at n = 1. Estimate::n is n.
/// requires: n >= 1; g.f takes points of g.dims coordinates.
/// throws: std::invalid_argument for n = 0.
/// source: Pharr, Jakob, Humphreys 2023, "Physically based rendering", section 2.1.3; for the
///   error, Owen, "Monte Carlo theory, methods and examples", chapter 2.
Estimate estimate(const Integrand& g, std::uint64_t n, Rng& rng);

/// 2.3  The quantile function (inverse CDF) at `u` of the exponential distribution, whose density
/// is rate exp(-rate x) for x >= 0. Non-decreasing in u, and within 4 ulp of -log1p(-u) / rate,
/// also for the smallest u; so finite for every rate of at least 1e-306.
/// requires: u in [0, 1), a finite rate > 0.
/// throws: std::invalid_argument if rate is not positive, or NaN.
/// source: Pharr, Jakob, Humphreys 2023, section 2.3; Owen, chapter 4.
double sample_exponential(double u, double rate);

/// 2.3  The quantile function at `u` of the density (a + 1) x^a on [0, 1]. In [0, 1],
/// non-decreasing in u, and within 4 ulp and the rounding of the exponent 1 / (a + 1), or of the
/// logarithm of u.
/// requires: u in [0, 1), a finite a > -1.
/// throws: std::invalid_argument if a is not above -1, or NaN.
/// source: as sample_exponential.
double sample_power(double u, double a);

/// 2.3  The density that sample_exponential samples: rate exp(-rate x) for x >= 0, 0 below.
/// requires: any x, a finite rate > 0.
/// throws: std::invalid_argument if rate is not positive, or NaN.
/// source: as sample_exponential.
double pdf_exponential(double x, double rate);

/// 2.3  The density that sample_power samples: (a + 1) x^a on [0, 1] with both ends, 0 outside.
/// requires: any x, a finite a > -1.
/// throws: std::invalid_argument if a is not above -1, or NaN.
/// source: as sample_exponential.
double pdf_power(double x, double a);

/// 2.4  The integral of the one-dimensional `g` over the support of `p`, as the mean of g(x) / p(x)
/// at `n` independent points x = p.sample(u). standard_error and Estimate::n are as in 2.2. A point
/// at which the pdf is 0 or infinite adds 0 and is counted.
/// requires: n >= 1; g.dims = 1; p.pdf is the density of p.sample(u) for a uniform u, 0 or at least
///   1e-300.
/// throws: std::invalid_argument for n = 0.
/// source: Pharr, Jakob, Humphreys 2023, section 2.2.2; Owen, chapter 9.
Estimate estimate_importance(const Integrand& g, const Density& p, std::uint64_t n, Rng& rng);

/// 2.5  The interval around `estimate` that contains the true value with probability `level` in the
/// limit of many samples: normal_quantile((1 + level) / 2) standard errors to either side.
/// requires: a standard error that is not NaN; level in (0, 1).
/// throws: std::invalid_argument if level is not inside (0, 1).
/// source: Owen, chapter 2.
Interval confidence_interval(const Estimate& estimate, double level);

/// 2.6  How many samples reduce the standard error to `target_error`, according to a pilot run:
/// n (standard error / target)^2, rounded up, and at least 1. Computed in double: 8 eps of it more
/// or fewer, and one sample too many, are accepted.
/// requires: a pilot with samples and a standard error; target_error > 0.
/// throws: std::invalid_argument if target_error is not positive, or NaN; if the pilot has n = 0 or
///   its standard error is NaN; and if the answer, computed in double, is 2^64 or more.
/// source: Owen, chapter 2.
std::uint64_t samples_for(const Estimate& pilot, double target_error);

/// 2.7  The irradiance at the origin (W/m^2), from `n` independent uniform points on the light: the
/// mean of area · radiance · cos(receiver) cos(light) / distance^2. standard_error as in 2.2.
/// requires: n >= 1; light.x0 < light.x1, light.y0 < light.y1, light.height > 0.
/// throws: std::invalid_argument for n = 0.
/// source: Pharr, Jakob, Humphreys 2023, section 4.2.
Estimate irradiance_area(const RectLight& light, std::uint64_t n, Rng& rng);

/// 2.7  The same irradiance from `n` independent directions in the receiver's hemisphere, with
/// density cos / pi: a sample is pi · radiance if its direction hits the light, and 0 if not.
/// requires: as irradiance_area.
/// throws: std::invalid_argument for n = 0.
/// source: Pharr, Jakob, Humphreys 2023, section 4.2, and appendix A.5.3 for Malley's method.
Estimate irradiance_hemisphere(const RectLight& light, std::uint64_t n, Rng& rng);

/// 2.8  Stretch, the speed task: fills `out` with independent uniform numbers in [0, 1), as fast as
/// you can and in any order. Each has at least 53 random bits. The generator advances, so two calls
/// are independent; equal generators give equal numbers.
/// requires: a span of any size, also empty; any generator, also one that always returns the same
///   word (then the numbers only have to lie in [0, 1)).
/// source: Blackman, Vigna 2021, "Scrambled linear pseudorandom number generators".
void uniforms(Rng& rng, std::span<double> out);

/// 2.9  Stretch: the irradiance of 2.7 by both ways at once, from `n` independent pairs of a point
/// on the light and a direction of the hemisphere. The value of a pair is the sum of two terms
/// f / (p_area + p_hemisphere), one at the direction to the point and one at the direction; f =
/// radiance · cos(receiver), 0 where no light is, and both densities are per solid angle.
/// standard_error as in 2.2, over the n pairs; Estimate::n is n.
/// requires: as irradiance_area.
/// throws: std::invalid_argument for n = 0.
/// source: Veach 1997, "Robust Monte Carlo methods for light transport simulation", section 9.2.2,
///   the balance heuristic.
Estimate irradiance_combined(const RectLight& light, std::uint64_t n, Rng& rng);

}  // namespace mc
