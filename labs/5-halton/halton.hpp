#pragma once
// Lab 5 · Halton and quasi-Monte Carlo: what you implement, in starter/halton.cpp. The handout is
// README.md here.
//
// Points that are not random at all, but spread more evenly than chance would spread them; and ways
// of making them random again without losing that. Indices count from 0. Misuse throws
// std::invalid_argument naming the argument, in particular where the indices first, first + 1, …
// of a column would run past the end of their range. Every coordinate lies in [0, 1), so below 1.

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "common/joe_kuo.hpp"
#include "common/points.hpp"
#include "common/rng.hpp"

namespace mc {

/// 5.1  The radical inverse: the digits of `index` in `base`, mirrored at the point, so that
/// 6 = 110 in base 2 becomes .011 = 3/8. Within 4 * 2^-53 of that fraction, and below 1, for every
/// index of 64 bits and every base. Throws for base < 2.
double radical_inverse(unsigned base, std::uint64_t index);

/// 5.2  The radical inverses of first, first + 1, …, one for each value of `column`: with the error
/// bound of 5.1, and as fast as you can. Throws for base < 2, and where `first` and the size of the
/// column lead past 2^64 - 1.
void radical_inverses(unsigned base, std::uint64_t first, std::span<double> column);

/// 5.3  The first `count` primes: 2, 3, 5, …
std::vector<unsigned> primes(std::size_t count);

/// 5.3  Points first, first + 1, … of the Halton sequence (Halton 1960): coordinate d is the
/// radical inverse in the d-th prime. Throws where `first` leads past 2^64 - 1.
void halton(PointSet& points, std::uint64_t first);

/// 5.4  The Hammersley points (Hammersley 1960): coordinate 0 of point i is i/N, coordinate d the
/// radical inverse of i in the (d-1)-th prime.
void hammersley(PointSet& points);

/// 5.5  Coordinate `dimension` (from 0) of points first, first + 1, … of the Sobol' sequence, by
/// the direction numbers of joe_kuo[dimension]: whole multiples of 2^-32, exact. In the sequence's
/// own order: point i is the exclusive or of the direction numbers of the bits of i, not of its
/// Gray code, and point 0 is the origin. Throws where there is no such `dimension`, and where
/// `first` leads past 2^32 - 1. A speed task.
void sobol(unsigned dimension, std::uint64_t first, std::span<double> column);

/// 5.6  The star discrepancy of N points of [0,1]: the largest difference between the length of an
/// interval [0, a) or [0, a] and the part of the points inside. Exact, up to rounding (1e-14).
/// Throws where there are no points, and where one of `x` lies outside [0,1].
double star_discrepancy(std::span<const double> x);

/// 5.6  The same in the plane: area of a box from the origin against the part of the points inside,
/// over all boxes, open and closed (Niederreiter 1972; de Clerck 1986). At most O(N^2 log N).
/// Throws as above, for `x` or `y`, and where their sizes differ.
double star_discrepancy(std::span<const double> x, std::span<const double> y);

/// 5.7  Shifts all points by one random vector, uniform in the unit cube, and wraps them around at
/// 1, so that each point by itself becomes uniform (Cranley, Patterson 1976).
void random_shift(PointSet& points, Rng& rng);

/// 5.8  Nested uniform scrambling in base 2 (Owen 1995): each of the 53 leading bits of a value is
/// flipped or not, at random, by a decision of its own for each string of bits that may stand
/// before it. That decision is a hash of the string and of all 64 bits of `seed`: so equal values
/// stay equal, in whatever column they stand, and columns of one axis can be made in parts. A hash
/// is not random: what must hold is that any two values are scrambled independently, up to the bits
/// that they share (then the variance is Owen's), and larger groups nearly so: the error of exp(x)
/// with 1,024 points of the line is Gaussian, with a kurtosis near 3. Each axis takes a seed of its
/// own.
/// requires: values in [0, 1), whole multiples of 2^-53.
void owen_scramble(std::span<double> column, std::uint64_t seed);

/// 5.9  As 5.2, with the digit at each position of the radical inverse replaced by a random
/// permutation of it: one permutation for each position, also for the endless zeros after the last
/// digit (to 2^-53). A function of index and seed alone. Throws as 5.2 does, and for base > 2^16.
/// (In base 2, where a permutation either swaps the digits or does not, this is a digital shift.)
void radical_inverses_scrambled(unsigned base, std::uint64_t first, std::span<double> column,
                                std::uint64_t seed);

}  // namespace mc
