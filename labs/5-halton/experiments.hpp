#pragma once
// The experiments of lab 5: what is run and measured in a submission. Point sets are returned
// column by column. Every value that the submission must write is NaN before the call.

#include <cstdint>
#include <vector>

#include "halton.hpp"
#include "runner/wire.hpp"

namespace mc::experiments {

/// 5.1: the radical inverse of each index.
std::vector<double> radical_inverse(unsigned base, std::vector<std::uint64_t> indices);

/// 5.2: the radical inverses of first … first + count - 1.
std::vector<double> radical_inverses(unsigned base, std::uint64_t first, std::uint64_t count);

/// 5.3: the first `count` primes; Halton points first … first + n - 1 in `dims` dimensions.
std::vector<unsigned> primes(std::uint64_t count);
std::vector<double> halton(std::uint64_t n, std::uint64_t dims, std::uint64_t first);

/// 5.4: the n Hammersley points in `dims` dimensions.
std::vector<double> hammersley(std::uint64_t n, std::uint64_t dims);

/// 5.5: one coordinate of Sobol' points first … first + count - 1.
std::vector<double> sobol(unsigned dimension, std::uint64_t first, std::uint64_t count);

/// 5.6: the star discrepancy of the points x, and of the points (x[i], y[i]).
double star_discrepancy_1d(std::vector<double> x);
double star_discrepancy_2d(std::vector<double> x, std::vector<double> y);

/// 5.7: `times` random shifts of the given points in `dims` dimensions, all with one generator.
/// Each shift starts from the given points. Returns `times` sets, one after another.
std::vector<double> random_shift(std::vector<double> points, std::uint64_t dims,
                                 std::uint64_t times, std::uint64_t seed);

/// 5.8: the column x scrambled with each seed. Returns one column per seed, one after another.
std::vector<double> owen_scramble(std::vector<double> x, std::vector<std::uint64_t> seeds);

/// 5.9: the scrambled radical inverses of first … first + count - 1 with each seed. Returns one
/// column per seed, one after another.
std::vector<double> radical_inverses_scrambled(unsigned base, std::uint64_t first,
                                               std::uint64_t count,
                                               std::vector<std::uint64_t> seeds);

/// 5.9: the same for any indices, each computed in a column of its own. Returns one list per seed,
/// one after another.
std::vector<double> scrambled_one_by_one(unsigned base, std::vector<std::uint64_t> indices,
                                         std::vector<std::uint64_t> seeds);

/// 5.10: the lattice of n points in `dims` dimensions with each seed. Returns one set per seed, one
/// after another.
std::vector<double> lattice(std::uint64_t n, std::uint64_t dims, std::vector<std::uint64_t> seeds);

/// 5.10: the tent transform of x.
std::vector<double> tent(std::vector<double> x);

/// For timing: makes a column of n values `rounds` times and returns the last value. Tasks 1, 2 and
/// 9 are radical inverses (9: scrambled) in base `base_or_dimension`; tasks 5 and 8 are Sobol'
/// points (8: scrambled) in that dimension. Round r scrambles with the seed s = `seed` + r and
/// starts at index 4096 (s mod 4096), so that no column can be copied from an earlier round; task 1
/// starts at 0.
double repeat(unsigned task, unsigned base_or_dimension, std::uint64_t n, std::uint64_t rounds,
              std::uint64_t seed);

/// What 5.5 and 5.8 are compared with: coordinates of Sobol' dimension 1, bit by bit; with task 8
/// each of 53 bits is flipped by a hash of those before it.
double repeat_plain(unsigned task, std::uint64_t n, std::uint64_t rounds);

/// For timing: makes n points in `dims` dimensions `rounds` times: 3 Halton points, 5 Sobol'
/// points, 8 scrambled Sobol' points, 9 scrambled Halton points, 10 a lattice with the tent
/// transform. The points are made in blocks of 32 KB (at least 1,024 points) that reuse the same
/// memory. Dimensions are made from the last to the first, so that code that makes all coordinates
/// of a point at once can do so for the highest dimension. Returns coordinate 0 of the last point
/// of a block.
double repeat_points(unsigned task, std::uint64_t n, std::uint64_t dims, std::uint64_t rounds);

}  // namespace mc::experiments
