#pragma once
// Lab 4 · blue noise: what you implement in starter/blue_noise.cpp. The handout is README.md in
// this folder. This lab is not linked with labs 1 to 3.
//
// Points that keep a minimum distance from each other, and the periodogram, which shows it. Points
// lie in [0,1)^2, and the square is a torus: left and right are joined, and so are top and bottom,
// so that a pattern has no border and copies of it fit together. Misuse throws
// std::invalid_argument with a message that names the argument. A function without a `throws:` line
// never throws.

#include <cstddef>
#include <span>
#include <vector>

#include "common/points.hpp"
#include "common/rng.hpp"

namespace mc {

/// 4.1  The squared distance of two points on the torus: from `a` to the nearest of the periodic
/// copies of `b`. At most 1/2.
/// requires: a and b in [0,1)^2.
double toroidal_distance_squared(Point2 a, Point2 b);

/// 4.2  Mitchell's best candidate. Point i, counted from 0, is the one of ceil(c i) + 1 independent
/// uniform candidates whose nearest earlier point is farthest away on the torus. `x` and `y` get
/// the points in that order. All random numbers come from `rng`.
/// throws: std::invalid_argument if the sizes of x and y differ or are 0; if c is not positive and
///   finite.
/// cost: O(c N^3) by the definition; 4.7 requires O(c N^2).
/// source: Mitchell 1991, "Spectrally optimal sampling for distribution ray tracing", section 4.
void best_candidate(std::span<double> x, std::span<double> y, double c, Rng& rng);

/// 4.3  A nearly maximal Poisson-disk pattern: random points of the torus, no two closer than
/// `radius`, about 0.7 / radius^2 of them, in two columns. Disks of that radius around the points
/// leave at most 0.3 % of the square uncovered, on average over patterns. One point if radius >
/// sqrt(1/2).
/// throws: std::invalid_argument if the radius is not positive, or NaN, or below 1e-5 (the points
///   would not fit into memory; the message then contains their approximate number, such as
///   1.5e+12).
/// cost: 4.7 requires O(N) for N points.
/// source: Cook 1986, "Stochastic sampling in computer graphics" (dart throwing); Ebeida et al.
///   2012, "A simple algorithm for maximal Poisson-disk sampling in high dimensions".
PointSet poisson_disk(double radius, Rng& rng);

/// 4.4  The periodogram of N points: P(k) = abs(sum of exp(-2 pi i (kx x + ky y)) over them)^2 / N
/// for kx and ky from -kmax to kmax. ky is the outer index: P(kx, ky) is at
/// power[(ky + kmax) (2 kmax + 1) + kx + kmax]. Independent points have 1 on average, for k != 0.
/// requires: points in [0,1)^2.
/// throws: std::invalid_argument if kmax < 1; if the sizes of x and y differ or are 0; if the size
///   of `power` is not (2 kmax + 1)^2.
/// cost: O(N kmax^2).
/// source: Lagae, Dutré 2008, "A comparison of methods for generating Poisson disk distributions".
void periodogram(std::span<const double> x, std::span<const double> y, int kmax,
                 std::span<double> power);

/// 4.5  The mean of a periodogram over rings: value r, from 0 to kmax, is the mean of `power` over
/// all (kx, ky) whose length sqrt(kx^2 + ky^2), rounded to the nearest integer, is r. The corners
/// beyond kmax belong to no ring. Value 0 is NaN: the power at k = 0 is N for any points.
/// throws: std::invalid_argument if kmax < 1; if the size of `power` is not (2 kmax + 1)^2.
/// source: Ulichney 1988, "Dithering with blue noise", Proceedings of the IEEE 76(1).
std::vector<double> radial_power(std::span<const double> power, int kmax);

/// 4.6  A tiled pattern: copies x copies copies of `pattern` fill the unit square, each 1/copies of
/// its size, in any order. Every coordinate is below 1, whatever rounding does.
/// throws: std::invalid_argument if copies < 1; if the pattern is empty or not two-dimensional.
PointSet tile(const PointSet& pattern, int copies);

/// 4.7  The speed task adds no function. In 4.2, find the nearest of i points without looking at
/// all of them, so that the cost of a candidate does not depend on the number of points: 4,096
/// points with c = 1 then take a fraction of a second. In 4.3, use time in proportion to the number
/// of points: 100,000 then take well below a second.

}  // namespace mc
