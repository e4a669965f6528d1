#pragma once
// Lab 3 · stratification: what you implement, in starter/stratification.cpp. The handout is
// README.md here.
//
// Cut the domain into N strata of equal volume and put one sample into each: samples cannot clump,
// and what the integrand does from stratum to stratum costs no variance any more. What is left is
// the variance within the strata. Throughout: points lie in [0,1)^d, whatever rounding does; every
// number comes from the generator that is passed in; misuse throws std::invalid_argument naming the
// argument.

#include <cstddef>
#include <cstdint>
#include <span>

#include "common/estimation.hpp"
#include "common/points.hpp"
#include "common/rng.hpp"
#include "independent.hpp"

namespace mc {

/// 3.1  N = x.size() points, one in each of the strata [i/N, (i+1)/N), in order: point i lies in
/// stratum i, uniformly and independently of all others. In order and in it as the computer sees
/// it: double(i) / N <= x[i] < double(i+1) / N, in double division, for every bit pattern that the
/// generator may return. (i + u) / N alone does not promise that: it may round up to the edge.
void stratified_1d(std::span<double> x, Rng& rng);

/// 3.2  The grid of n cells that is as square as n allows: nx * ny = n, nx >= ny, and ny as large
/// as that leaves it. A prime n is n cells in a row. At worst about sqrt(n) steps. Throws
/// std::invalid_argument for n = 0.
Grid strata(std::size_t n);

/// 3.3  A jittered grid: one point (x[k], y[k]) in each cell of `grid`, uniform in it and
/// independent of the others, x and y independent of each other. The cells may come in any order;
/// their edges are double(i) / nx and double(j) / ny as in 3.1 (Cook 1986, "Stochastic sampling in
/// computer graphics"). Throws std::invalid_argument where the sizes of x and y differ, where the
/// grid has no cells, and where nx * ny, which may be more than 64 bits hold, is not their size.
void stratified_2d(std::span<double> x, std::span<double> y, Grid grid, Rng& rng);

/// 3.4  Puts the values into random order, each of the N! orders as likely as any other, in about N
/// steps (Durstenfeld 1964, "Algorithm 235: random permutation").
void shuffle(std::span<double> x, Rng& rng);

/// 3.4  Stratified points of any number of dimensions, by padding: dimensions (0,1), (2,3), … each
/// a jittered grid of strata(N) cells, an odd last dimension stratified in 1D. Patterns are put
/// side by side in orders that have nothing to do with each other or with anything else, so that
/// any first n < N points are a fair sample too (Pharr, Jakob, Humphreys 2023, "Physically based
/// rendering", section 8.5). Two 1D patterns are not a 2D pattern: they stratify each axis and
/// leave the plane to chance.
void stratified(PointSet& points, Rng& rng);

/// 3.5  One point in each of the per_axis^dims cells of a grid over all dimensions at once, uniform
/// in its cell, in any order: full stratification, for those who can pay for it. Throws
/// std::invalid_argument for per_axis = 0, and where per_axis^dims, which may be more than 64 bits
/// hold, is not the number of points.
void stratified_nd(PointSet& points, std::size_t per_axis, Rng& rng);

/// 3.6  Latin hypercube samples: every axis by itself stratified as in 3.1, the orders of the axes
/// independent of each other (McKay, Beckman, Conover 1979, "A comparison of three methods for
/// selecting values of input variables in the analysis of output from a computer code").
void latin_hypercube(PointSet& points, Rng& rng);

/// 3.7  Multi-jittered points: one point in each cell of `grid`, as in 3.3, and at the same time
/// one x in each of N strata and one y in each of N strata, as in 3.1 (Chiu, Shirley, Wang 1994,
/// "Multi-jittered sampling", Graphics Gems IV). Each point is uniform in its cell: the canonical
/// arrangement must be shuffled. Columns may share one permutation and rows another (Kensler 2013,
/// "Correlated multi-jittered sampling"). Any order of points. Throws as 3.3 does.
void multi_jittered(std::span<double> x, std::span<double> y, Grid grid, Rng& rng);

/// 3.8  An estimate with an error bar for points that are not independent of each other: the mean
/// of `replicates` means, each over n points that `generator` made afresh, and the standard error
/// that those means have among themselves. Estimate::n is n * replicates, the number of
/// evaluations. One replicate has no spread: its standard error is NaN. Throws
/// std::invalid_argument for n = 0 and for no replicates (Owen, "Monte Carlo theory, methods and
/// examples", chapter 17).
Estimate estimate_replicated(const Integrand& g, const Generator& generator, std::uint64_t n,
                             std::uint64_t replicates, Rng& rng);

/// 3.9  The speed task has no function of its own: make 3.1 and 3.3 cost no more than the random
/// numbers that they use. Every promise above still holds, for every size.

}  // namespace mc
