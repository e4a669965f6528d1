#pragma once
// What lab 5 measures of a submission. Point sets are returned column by column; what is filled in
// is NaN before, so that a value that was never written shows.

#include <cstdint>
#include <vector>

#include "halton.hpp"
#include "runner/wire.hpp"

namespace mc::experiments {

/// 5.1: of each of `indices`.
std::vector<double> radical_inverse(unsigned base, std::vector<std::uint64_t> indices);

/// 5.2: of first … first + count - 1.
std::vector<double> radical_inverses(unsigned base, std::uint64_t first, std::uint64_t count);

/// 5.3: the first `count` primes; n Halton points of `dims` dimensions.
std::vector<unsigned> primes(std::uint64_t count);
std::vector<double> halton(std::uint64_t n, std::uint64_t dims, std::uint64_t first);

/// 5.4: n points of `dims` dimensions.
std::vector<double> hammersley(std::uint64_t n, std::uint64_t dims);

/// 5.5: points first … first + count - 1 of one dimension.
std::vector<double> sobol(unsigned dimension, std::uint64_t first, std::uint64_t count);

/// 5.6: of the points x; of the points (x[i], y[i]).
double star_discrepancy_1d(std::vector<double> x);
double star_discrepancy_2d(std::vector<double> x, std::vector<double> y);

/// 5.7: `points`, of `dims` dimensions, shifted `times` times with one generator, each time from
/// where they were first: `times` sets, one after the other.
std::vector<double> random_shift(std::vector<double> points, std::uint64_t dims,
                                 std::uint64_t times, std::uint64_t seed);

/// 5.8: the column x scrambled by each of `seeds`: as many columns, one after the other.
std::vector<double> owen_scramble(std::vector<double> x, std::vector<std::uint64_t> seeds);

/// 5.9: of first … first + count - 1, by each of `seeds`: as many columns, one after the other.
std::vector<double> radical_inverses_scrambled(unsigned base, std::uint64_t first,
                                               std::uint64_t count,
                                               std::vector<std::uint64_t> seeds);

/// 5.9: of each of `indices`, in its own column, by each of `seeds`: as many lists.
std::vector<double> scrambled_one_by_one(unsigned base, std::vector<std::uint64_t> indices,
                                         std::vector<std::uint64_t> seeds);

/// 5.10: n points of `dims` dimensions by each of `seeds`: as many sets, one after the other.
std::vector<double> lattice(std::uint64_t n, std::uint64_t dims, std::vector<std::uint64_t> seeds);

/// 5.10: the column x, folded.
std::vector<double> tent(std::vector<double> x);

/// For timing: a column of n values, `rounds` times, by task 5.`task`: 1 and 2 radical inverses, 9
/// scrambled ones, in that base; 5 Sobol', 8 Sobol' scrambled, in that dimension. Round r has the
/// seed s = `seed` + r, by which it scrambles; it begins at index 4096 (s mod 4096), below 2^24, so
/// that no column can be had from one before (task 1 at 0). The last x.
double repeat(unsigned task, unsigned base_or_dimension, std::uint64_t n, std::uint64_t rounds,
              std::uint64_t seed);

/// For timing: n points of `dims` dimensions, `rounds` times, by task 5.`task`: 3 Halton points, 5
/// Sobol' points, 8 Sobol' points scrambled, 9 Halton points scrambled, 10 a lattice, folded. They
/// are made in blocks of 32 KB, but of 1,024 points at least, over and over in the same place; and
/// from the last dimension to the first, which suits code that makes whole points. Returns the last
/// coordinate.
double repeat_points(unsigned task, std::uint64_t n, std::uint64_t dims, std::uint64_t rounds);

}  // namespace mc::experiments
