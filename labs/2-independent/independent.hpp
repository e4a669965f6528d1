#pragma once
// Lab 2 · independent sampling: what you implement, in starter/independent.cpp. The handout is
// README.md here.
//
// G_N = 1/N sum g(x_i), the x_i independent: right on average, wrong by sigma / sqrt(N), and able
// to say so itself. Lab 1's means and variances are at hand. What is undefined is a quiet NaN;
// misuse throws std::invalid_argument naming the argument; every n below must be at least 1.

#include <cstdint>
#include <span>

#include "common/estimation.hpp"
#include "common/normal_quantile.hpp"
#include "common/rect_light.hpp"
#include "common/rng.hpp"
#include "variance.hpp"

namespace mc {

/// 2.1  A uniform number in [0, 1) from the upper 53 bits of a word: floor(bits / 2^11) 2^-53,
/// exactly. Never 1.
double to_unit(std::uint64_t bits);

/// 2.2  The integral of `g` over the unit cube, as the mean of g at `n` independent uniform points,
/// with exactly n evaluations. standard_error is s / sqrt(n), s^2 the sample variance of the values
/// of g; NaN at n = 1. Its random numbers come from `rng` alone.
Estimate estimate(const Integrand& g, std::uint64_t n, Rng& rng);

/// 2.3  Sampling by inversion: the x below which the distribution has the share `u`, so
/// non-decreasing in u, for every u in [0, 1). Finite, and inside the support with its ends.
///
/// Exponential, p(x) = rate exp(-rate x) for x >= 0: within 4 ulp of -log1p(-u) / rate, also for
/// the smallest u. Throws where `rate` is not positive.
double sample_exponential(double u, double rate);

/// Power, p(x) = (a + 1) x^a on [0, 1]. Throws where `a` is not above -1.
double sample_power(double u, double a);

/// 2.3  The densities of the two at any x, 0 outside the support. They throw for the same
/// parameters.
double pdf_exponential(double x, double rate);
double pdf_power(double x, double a);

/// 2.4  The integral of the one-dimensional `g` over the support of `p`, as the mean of g(x) / p(x)
/// at `n` points x distributed as p; standard_error as in 2.2. A point at which the pdf is 0 or
/// infinite adds 0, and is counted.
Estimate estimate_importance(const Integrand& g, const Density& p, std::uint64_t n, Rng& rng);

/// 2.5  The interval around `estimate` that covers the true value with probability `level`, in the
/// limit of many samples: normal_quantile() of the right share, times the standard error, to either
/// side. Throws where `level` is not inside (0, 1).
Interval confidence_interval(const Estimate& estimate, double level);

/// 2.6  How many samples bring the standard error down to `target_error`, judging by a pilot run:
/// rounded up, and at least 1. Throws where `target_error` is not positive, where the pilot has no
/// samples or no standard error (NaN), and where the answer does not fit into 64 bits.
std::uint64_t samples_for(const Estimate& pilot, double target_error);

/// 2.7  The irradiance at the origin (W/m^2), from `n` points chosen uniformly on the light:
/// area · radiance · cos(receiver) cos(light) / distance^2.
Estimate irradiance_area(const RectLight& light, std::uint64_t n, Rng& rng);

/// 2.7  The same irradiance from `n` directions of the receiver's hemisphere with density cos / pi:
/// pi · radiance where a direction meets the light, 0 elsewhere.
Estimate irradiance_hemisphere(const RectLight& light, std::uint64_t n, Rng& rng);

/// 2.8  The speed task: fills `out` with uniform numbers in [0, 1) that carry at least 53
/// independent bits each, as fast as you can, in any order. The generator moves on, so that two
/// calls have nothing in common; the same generator gives the same numbers.
void uniforms(Rng& rng, std::span<double> out);

}  // namespace mc
