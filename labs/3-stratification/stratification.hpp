#pragma once
// Lab 3 · stratification: what you implement in starter/stratification.cpp. The handout is
// README.md in this folder.
//
// Cut the domain into N strata of equal volume and put one point into each. The variance of an
// estimate is then the variance within the strata; the variance between them does not contribute.
// Throughout:
//
// * Points lie in [0,1)^d, whatever rounding does. Every value that is passed in is overwritten.
// * Random numbers come from the generator that is passed in, in any order, and from nowhere else;
//   it advances, so that the next call uses different numbers.
// * Misuse throws std::invalid_argument with a message that names the argument. A function without
//   a `throws:` line never throws. A function without a `cost:` line takes time linear in the
//   number of values that it writes.

#include <cstddef>
#include <cstdint>
#include <span>

#include "common/estimation.hpp"
#include "common/points.hpp"
#include "common/rng.hpp"
#include "independent.hpp"

namespace mc {

/// 3.1  One point in each of the N = x.size() strata [i/N, (i+1)/N), in order: x[i] is uniform in
/// stratum i and independent of all others. Containment holds in floating point: double(i) / N <=
/// x[i] < double(i+1) / N in double division, for every bit pattern that the generator returns.
/// requires: N >= 1.
/// source: Cook 1986, "Stochastic sampling in computer graphics"; Pharr, Jakob, Humphreys 2023,
///   "Physically based rendering", section 2.2.1.
void stratified_1d(std::span<double> x, Rng& rng);

/// 3.2  The grid of n cells that is as square as n allows: nx * ny = n, and ny is the largest
/// divisor of n that is at most sqrt(n). A prime n gives a row of n cells.
/// requires: n >= 1; any 64-bit number.
/// throws: std::invalid_argument for n = 0.
/// cost: sqrt(n) - ny + 1 divisions: search down from sqrt(n).
Grid strata(std::size_t n);

/// 3.3  A jittered grid: one point (x[k], y[k]) in each cell of `grid`, uniform in it and
/// independent of the others, x and y independent of each other. The cells come in any order.
/// Containment holds in floating point, as in 3.1, with edges double(i) / nx and double(j) / ny.
/// requires: x and y of size nx * ny; nx and ny at least 1. The product nx * ny may need more than
///   64 bits; then it is not the size.
/// throws: std::invalid_argument if the sizes of x and y differ, if the grid has no cells, and if
///   nx * ny is not the number of points.
/// source: Cook 1986.
void stratified_2d(std::span<double> x, std::span<double> y, Grid grid, Rng& rng);

/// 3.4  Puts the values into random order: each of the N! permutations is equally likely.
/// requires: any number of values, also 0.
/// source: Durstenfeld 1964, "Algorithm 235: random permutation".
void shuffle(std::span<double> x, Rng& rng);

/// 3.4  Stratified points of any number of dimensions, by padding: dimensions (0,1), (2,3), … are
/// each a jittered grid of strata(N) cells, an odd last dimension is a pattern of 3.1. Each pattern
/// is shuffled independently, x and y of a point together, so that the permutations of the patterns
/// are independent and the first n < N points are an unbiased sample. (Two 1D patterns are not a 2D
/// pattern.)
/// requires: at least one point and one dimension.
/// source: Pharr, Jakob, Humphreys 2023, section 8.5.
void stratified(PointSet& points, Rng& rng);

/// 3.5  Full stratification: one point in each of the per_axis^dims cells of a grid over all
/// dimensions at once, uniform in its cell, in any order.
/// requires: per_axis^dims = points.size(); per_axis >= 1, dims >= 1. The power may need more than
///   64 bits; then it is not the size.
/// throws: std::invalid_argument for per_axis = 0, and if per_axis^dims is not the number of
///   points.
/// source: Owen, "Monte Carlo theory, methods and examples", chapter 10.
void stratified_nd(PointSet& points, std::size_t per_axis, Rng& rng);

/// 3.6  A Latin hypercube: every axis is stratified as in 3.1, and its order is random and
/// independent of the orders of the other axes. The points come in any order, so one axis may stay
/// sorted: this changes no mean over all N points.
/// requires: at least one point and one dimension.
/// source: McKay, Beckman, Conover 1979, "A comparison of three methods for selecting values of
///   input variables in the analysis of output from a computer code".
void latin_hypercube(PointSet& points, Rng& rng);

/// 3.7  Multi-jittered points: one point in each cell of `grid`, one x in each of the N strata of
/// x, and one y in each of the N strata of y. Each point is uniform in its cell, so the canonical
/// arrangement must be permuted at random; columns may share one permutation, and rows another.
/// The points come in any order.
/// requires: as stratified_2d.
/// throws: as stratified_2d.
/// source: Chiu, Shirley, Wang 1994, "Multi-jittered sampling", Graphics Gems IV; Kensler 2013,
///   "Correlated multi-jittered sampling", for shared permutations.
void multi_jittered(std::span<double> x, std::span<double> y, Grid grid, Rng& rng);

/// 3.8  An estimate with an error bar for points that are not identically distributed (jittered
/// points are independent, but s^2 estimates the variance within plus that between the strata) or
/// not independent (3.6, 3.7): the mean of `replicates` means of g, each over a fresh
/// PointSet(n, g.dims) from `generator`, and the standard error of that mean, from the sample
/// variance of the means. NaN for one replicate. Estimate::n is n * replicates, the number of
/// evaluations.
/// requires: n >= 1, replicates >= 1; a generator that writes every value, in one call.
/// throws: std::invalid_argument for n = 0 and for replicates = 0.
/// cost: one call of `generator` per replicate, one evaluation of g per point.
/// source: Owen, "Monte Carlo theory, methods and examples", chapter 17.
Estimate estimate_replicated(const Integrand& g, const Generator& generator, std::uint64_t n,
                             std::uint64_t replicates, Rng& rng);

/// 3.9  The irradiance at the origin (W/m^2) from stratified points of a light: in each replicate a
/// jittered grid (3.3), mapped to the light as in 2.7, x = x0 + (x1 - x0) u and y = y0 + (y1 - y0)
/// v; the mean of area · radiance · cos(receiver) cos(light) / distance^2 over its nx * ny points.
/// The error bar is that of 3.8. Estimate::n is nx * ny * replicates.
/// requires: light.x0 < light.x1, light.y0 < light.y1, light.height > 0.
/// throws: std::invalid_argument if the grid has no cells, and for replicates = 0.
/// source: Pharr, Jakob, Humphreys 2023, sections 2.2.1 and 4.2.
Estimate irradiance_stratified(const RectLight& light, Grid grid, std::uint64_t replicates,
                               Rng& rng);

/// 3.10  Stretch, no function: make 3.1 and 3.3 cost no more than the random numbers that they use.

}  // namespace mc
