#pragma once
// Lab 5 · Halton and quasi-Monte Carlo: what you implement in starter/halton.cpp. The handout is
// README.md in this folder. This lab is not linked with labs 1 to 4.
//
// Low-discrepancy points, which are deterministic and cover boxes more evenly than random points
// do, and ways to randomize them that keep this property. Indices, dimensions and positions of
// digits count from 0. Every coordinate that is written lies in [0, 1). Misuse throws
// std::invalid_argument with a message that names the argument. A function without a `throws:` line
// never throws.

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "common/joe_kuo.hpp"
#include "common/lattice_vector.hpp"
#include "common/points.hpp"
#include "common/rng.hpp"

namespace mc {

/// 5.1  The radical inverse: the digits of `index` in `base`, mirrored at the radix point, so that
/// 6 = 110 in base 2 becomes .011 = 3/8. Within 4 * 2^-53 of that fraction, and below 1, for every
/// 64-bit index and every base.
/// throws: std::invalid_argument if base < 2.
/// source: van der Corput 1935, "Verteilungsfunktionen" (base 2); Halton 1960.
double radical_inverse(unsigned base, std::uint64_t index);

/// 5.2  The radical inverses of first, first + 1, …, one for each value of `column`, with the error
/// bound of 5.1. A stretch task, for speed: judged and shown, but worth no points.
/// throws: std::invalid_argument if base < 2; if the last index is above 2^64 - 1.
void radical_inverses(unsigned base, std::uint64_t first, std::span<double> column);

/// 5.3  The first `count` primes: 2, 3, 5, …
/// cost: at most O(count^2): trial division by the smaller primes.
std::vector<unsigned> primes(std::size_t count);

/// 5.3  Points first, first + 1, … of the Halton sequence: coordinate d is the radical inverse in
/// the d-th prime, d from 0, within the bound of 5.1. Call 5.1, or 5.2 if you wrote it.
/// requires: at least one point and one dimension.
/// throws: std::invalid_argument if the last index is above 2^64 - 1.
/// source: Halton 1960, "On the efficiency of certain quasi-random sequences of points in
///   evaluating multi-dimensional integrals".
void halton(PointSet& points, std::uint64_t first);

/// 5.4  The Hammersley points: coordinate 0 of point i is i/N, coordinate d > 0 is the radical
/// inverse of i in the (d-1)-th prime.
/// requires: at least one point and one dimension.
/// source: Hammersley 1960, "Monte Carlo methods for solving multivariable problems".
void hammersley(PointSet& points);

/// 5.5  Coordinate `dimension` of points first, first + 1, … of the Sobol' sequence: the XOR of the
/// direction numbers of those bits that are set in the index. Exact multiples of 2^-32, in the
/// sequence's own order (not the Gray-code order); point 0 is the origin. A speed task.
/// throws: std::invalid_argument if joe_kuo has no such dimension; if the last index is above
///   2^32 - 1.
/// source: Bratley, Fox 1988, "Algorithm 659: implementing Sobol's quasirandom sequence generator",
///   equations 2 and 3; numbers from Joe, Kuo 2008.
void sobol(unsigned dimension, std::uint64_t first, std::span<double> column);

/// 5.6  The star discrepancy of N points in [0,1]: the largest difference between the length of
/// an interval [0, a) or [0, a], a <= 1, and the fraction of the points inside. Exact within 1e-14.
/// throws: std::invalid_argument if there are no points; if a value is outside [0,1], or NaN.
/// cost: O(N log N).
/// source: Niederreiter 1992, "Random number generation and quasi-Monte Carlo methods", theorem
///   2.6.
double star_discrepancy(std::span<const double> x);

/// 5.6  The same in the plane: the area of a box at the origin and the fraction of the points
/// inside, over all open and all closed boxes. Exact within 1e-14.
/// throws: std::invalid_argument if there are no points; if the sizes of x and y differ; if a value
///   is outside [0,1], or NaN.
/// cost: at most O(N^2 log N).
/// source: Niederreiter 1972, "Discrepancy and convex programming"; de Clerck 1986, "A method for
///   exact calculation of the stardiscrepancy of plane sets applied to the sequences of
///   Hammersley".
double star_discrepancy(std::span<const double> x, std::span<const double> y);

/// 5.7  Cranley-Patterson rotation: shifts all points by one random vector, uniform in the unit
/// cube, and wraps them around at 1. Each individual point becomes uniform.
/// requires: at least one point and one dimension; coordinates in [0,1).
/// source: Cranley, Patterson 1976, "Randomization of number theoretic methods for multiple
///   integration".
void random_shift(PointSet& points, Rng& rng);

/// 5.8  Nested uniform scrambling in base 2: flips each of the 53 leading bits of a value, or not,
/// by an independent random decision for each string of preceding bits. The decision is a hash of
/// that string and of all 64 bits of `seed`: a function of value and seed alone, so equal values
/// stay equal in any column, and a column may be computed in parts. Use a different seed for each
/// axis: decisions of different seeds are unrelated, also those for different strings.
///
/// How random the decisions must be: any two are independent, so that the variance is that of
/// independent decisions (Owen's); so are any three, wherever they are, as far as 1,500 seeds show.
/// Larger groups are nearly independent: for 1,024 points in one dimension, the error of exp(x) is
/// close to Gaussian.
/// requires: values in [0,1), integer multiples of 2^-53.
/// source: Owen 1995, "Randomly permuted (t,m,s)-nets and (t,s)-sequences".
void owen_scramble(std::span<double> column, std::uint64_t seed);

/// 5.9  As 5.2, with the digit at each position of the radical inverse mapped by a random
/// permutation: an independent permutation for each position, also for the infinitely many trailing
/// zeros (down to 2^-53). A function of base, index and all 64 bits of the seed alone, to the last
/// bit: neither the position of an index in its column nor the length of the column matters. In
/// base 2 this is a digital shift.
/// throws: std::invalid_argument if base < 2 or base > 2^16; if the last index is above 2^64 - 1.
/// source: Owen 2017, "A randomized Halton algorithm in R".
void radical_inverses_scrambled(unsigned base, std::uint64_t first, std::span<double> column,
                                std::uint64_t seed);

/// 5.10  A rank-1 lattice of N points, shifted at random: coordinate d of point i is i z_d / N +
/// s_d modulo 1, with z = lattice_vector. The shift s is uniform in the unit cube, a function of
/// all 64 bits of `seed`. Within 4 * 2^-53, modulo 1, for every N. A stretch task: judged and
/// shown, but worth no points.
/// requires: at least one point and one dimension.
/// throws: std::invalid_argument if `points` has more dimensions than lattice_vector.
/// source: Korobov 1959, "The approximate computation of multiple integrals"; Cranley, Patterson
///   1976 (the shift).
void lattice(PointSet& points, std::uint64_t seed);

/// 5.10  The tent transform: x becomes 1 - |2x - 1|, within 2^-52, below 1. Folds [0, 1) in the
/// middle, so that smooth integrands become periodic.
/// requires: values in [0, 1).
/// source: Hickernell 2002, "Obtaining O(N^(-2+eps)) convergence for lattice quadrature rules".
void tent(std::span<double> column);

}  // namespace mc
