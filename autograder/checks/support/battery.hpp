#pragma once
// One battery of tests for all random constructions. Each is a known transform of independent
// uniform numbers: a check inverts the transform (inversions.hpp) and passes the uniforms to
// expect_independent_uniforms(), which tests
//
//   bits        the fraction of u 2^k is uniform, for k = 0 and from 8 up to the last bits
//   extremes    the smallest and the largest value are close enough to 0 and 1
//   repeats     no value occurs twice, in one replicate or in two (birthday count)
//   values      all values together are uniform (Kolmogorov-Smirnov)
//   positions   each position is uniform
//   pairs       positions are independent, pair by pair: m u + n v is uniform modulo 1
//   triples     so are three positions: u + v + w and its variants are uniform modulo 1
//   bits of pairs  any two bits, of one number or of two, are equal half of the time
//   lags        values a power of two apart, or half the list apart, are independent, in one
//               replicate and across replicates
//   rows        the sum of a replicate has the variance of independent numbers
//
// Null distributions are exact or conservative (Rayleigh's test, Bonferroni's inequality). The
// alpha of a call is divided evenly among these ten parts.

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "checks/support/statistics.hpp"

namespace mc::checks {

/// Replicates of `positions` numbers each, all independent and uniform under the null hypothesis.
struct Uniforms {
  std::string call;                 ///< the measurement: "stratified_1d(16, 1000, 7)"
  std::size_t positions = 1;        ///< numbers in one replicate
  std::vector<double> values = {};  ///< replicate by replicate
  /// The number of accurate bits per value: an inversion loses some; fill_cell() does not.
  int bits = 53;
  std::function<std::string(std::size_t)> name = {};

  std::size_t replicates() const { return positions == 0 ? 0 : values.size() / positions; }
};

struct Randomness {
  std::string words;     ///< the null hypothesis: "the points of 3.1 are uniform"
  double alpha = 1e-8;   ///< of the whole battery; a lab has at most 80 such tests
  std::string rule;      ///< the hint if the numbers do not show what is wrong
  Likely repeated = {};  ///< the hint if numbers repeat
  Likely same = {};      ///< the hint if one position is a function of another
  /// What the program should have done, if the numbers are not its own but computed from its
  /// result: then patterns in the numbers give no hint.
  std::string expected = {};
  bool is_certain = false;  ///< print `rule`, whatever the numbers show
  /// Computes the hint if that takes long or needs more than the numbers; empty if there is none.
  std::function<Likely()> explain = {};
};

/// The numbers, at least 200, are uniform and independent. `only_each` skips the tests of
/// independence (pairs, bits of pairs, repeats, lags, rows).
void expect_independent_uniforms(const Uniforms& numbers, const Randomness& claim,
                                 bool only_each = false);

/// The same, but returns the failure instead of ending the check.
std::optional<Failure> dependence_in(const Uniforms& numbers, const Randomness& claim,
                                     bool only_each = false);

/// A visible fault of numbers that should be independent and uniform: constant, too few bits,
/// repeated, one position a function of another, a part of [0, 1) only. Empty if there is none.
Likely visible_fault(const Uniforms& numbers, const Randomness& claim);

}  // namespace mc::checks
