#pragma once
// One battery for all randomness. Every randomized construction of the labs is a known transform of
// independent uniform numbers: a check inverts the transform (inversions.hpp) and hands the
// uniforms to expect_independent_uniforms(), which tests
//
//   bits        the fraction of u 2^k is uniform, for k from 8 up to the last bits
//   extremes    the smallest and the largest value are as near to 0 and 1 as they must be
//   repeats     no value comes again, in this or in another replicate (birthday count)
//   values      all values together are uniform (Kolmogorov-Smirnov)
//   positions   each position by itself is uniform
//   pairs       positions are independent, pair by pair: m u + n v is uniform modulo 1
//   bits of pairs  two bits of a number, or of a pair of numbers, are equal half of the time
//   lags        values a power of two apart, or half of all, are independent, in this replicate and
//               in the next ones
//   rows        the sum of a replicate has the variance of independent numbers
//
// Null distributions are exact, or err towards passing (Rayleigh's test, Bonferroni's inequality).
// The alpha of a call is divided evenly among these nine parts.

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "checks/support/statistics.hpp"

namespace mc::checks {

/// Replicates of `positions` numbers each, in [0, 1): under the null hypothesis all of them are
/// independent and uniform.
struct Uniforms {
  std::string call;                 ///< what was measured: "stratified_1d(16, 1000, 7)"
  std::size_t positions = 1;        ///< numbers in one replicate
  std::vector<double> values = {};  ///< replicate by replicate
  /// To how many bits each value is known: an inversion loses some. Values that were made from
  /// whole numbers and filled up at random (fill_cell) have 53.
  int bits = 53;
  /// Names a position: "cell (3, 4)".
  std::function<std::string(std::size_t)> name = {};

  std::size_t replicates() const { return positions == 0 ? 0 : values.size() / positions; }
};

/// What the check claims of them.
struct Randomness {
  std::string words;          ///< "the points of 3.1 are uniform in their strata": names the null
  double alpha = 1e-8;        ///< of the whole battery
  std::string otherwise;      ///< the hint if the numbers themselves do not show what is wrong
  std::string repeated = {};  ///< where numbers come again
  std::string same = {};      ///< where one position is a function of another
  /// What the program should have done, where the numbers are not its own but computed from what it
  /// did: then nothing that is visible in them is a hint.
  std::string expected = {};
  /// Finds the hint, which takes long or needs more than the numbers; empty where it finds none.
  std::function<std::string()> explain = {};
};

/// The numbers are uniform and independent; wants at least 200 numbers. `only_each` leaves out what
/// needs independent positions (pairs, lags, rows, repeats): for the places of shuffled values.
void expect_independent_uniforms(const Uniforms& numbers, const Randomness& claim,
                                 bool only_each = false);

/// The same without ending a check: what it would say.
std::optional<Failure> dependence_in(const Uniforms& numbers, const Randomness& claim,
                                     bool only_each = false);

/// What is visibly wrong with numbers that should be independent and uniform: constant, too narrow,
/// too few bits, repeated, one position a function of another. Empty where nothing is.
std::string visible_fault(const Uniforms& numbers, const Randomness& claim);

}  // namespace mc::checks
