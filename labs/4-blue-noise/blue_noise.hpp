#pragma once
// Lab 4 · blue noise: what you implement, in starter/blue_noise.cpp. The handout is README.md here.
//
// Points that keep their distance from each other, and the periodogram, which shows it. Points lie
// in [0,1)^2, and the square is a torus: left meets right and top meets bottom, so that a pattern
// has no edge and can be laid beside itself. Misuse throws std::invalid_argument naming the
// argument.

#include <cstddef>
#include <span>
#include <vector>

#include "common/points.hpp"
#include "common/rng.hpp"

namespace mc {

/// 4.1  The squared distance of two points of [0,1)^2 on the torus: that of `a` to the nearest of
/// all copies of `b`. At most 1/2.
double toroidal_distance_squared(Point2 a, Point2 b);

/// 4.2  Mitchell's best candidate (Mitchell 1991, "Spectrally optimal sampling for distribution ray
/// tracing", section 4). Point i, counted from 0, is that one of ceil(c i) + 1 uniform candidates
/// whose nearest point among those before it is farthest away, on the torus. `x` and `y` receive
/// the points in that order. Throws where their sizes differ, where there are none, and unless c is
/// positive and finite.
void best_candidate(std::span<double> x, std::span<double> y, double c, Rng& rng);

/// 4.3  A Poisson-disk pattern: random points of the torus, no two closer than `radius`, and hardly
/// room for one more: discs of that radius around the points leave at most 0.3 % of the square
/// uncovered. About 0.7 / radius^2 points, in two columns; one point where radius > sqrt(1/2).
/// Throws for a radius that is not positive, or NaN, and below 1e-5, where memory would not hold
/// the points: the text then says about how many there would be, as a plain number (1.5e+12).
PointSet poisson_disk(double radius, Rng& rng);

/// 4.4  The periodogram of N points: abs(sum over them of exp(-2 pi i (kx x + ky y)))^2 / N for kx
/// and ky from -kmax to kmax, ky outer: `power` holds (2 kmax + 1)^2 values, that of (kx, ky) at
/// [(ky + kmax) (2 kmax + 1) + kx + kmax]. Independent points have 1 on average, all k but 0.
/// Throws for kmax < 1, no points, sizes of x and y that differ, and another size of `power`.
void periodogram(std::span<const double> x, std::span<const double> y, int kmax,
                 std::span<double> power);

/// 4.5  A periodogram's mean over rings: [r] is the mean of all (kx, ky) with abs(k) = sqrt(kx^2 +
/// ky^2) rounded to r, for r from 0 to kmax; the corners beyond belong to no ring. [0] is NaN: the
/// power at k = 0 is N for any points. Throws for kmax < 1 and another size than (2 kmax + 1)^2.
std::vector<double> radial_power(std::span<const double> power, int kmax);

/// 4.6  `copies` x `copies` copies of a pattern in two dimensions, pieced together in the unit
/// square, each 1/copies of its size; in any order. Every coordinate is below 1, whatever rounding
/// does. Throws for copies < 1, a pattern without points, and one that has not two dimensions.
PointSet tile(const PointSet& pattern, int copies);

/// 4.7  The speed task has no function of its own: make 4.2 find the nearest of i points without
/// looking at all of them, so that a candidate costs the same however many points there are (4,096
/// points with c = 1 then take a fraction of a second), and 4.3 take time and random numbers in
/// proportion to its points (100,000 then take well below a second).

}  // namespace mc
