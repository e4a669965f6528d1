#pragma once
// What lab 1 measures of a submission.

#include <cstdint>
#include <vector>

#include "runner/wire.hpp"
#include "variance.hpp"

namespace mc {
MC_FIELDS(Moments, count, mean, m2)
}  // namespace mc

namespace mc::experiments {

/// 1.1, 1.2, 1.3: of the values x.
double mean(std::vector<double> x);
double variance_textbook(std::vector<double> x);
double variance_two_pass(std::vector<double> x);

/// 1.3: of n equal values, for each of `constants`.
std::vector<double> two_pass_of_constants(std::vector<double> constants, std::uint64_t n);

/// 1.4: the moments after add() of each value of x in turn; and variance() of given moments.
Moments welford(std::vector<double> x);
double variance_of(Moments moments);

/// 1.4: what becomes of `moments` by add() of `count` values: x from its beginning to its end, over
/// and over.
Moments stream(Moments moments, std::vector<double> x, std::uint64_t count);

/// 1.5: of two moments; and of x added in parts of the given sizes, each merged into the whole.
Moments merge(Moments a, Moments b);
Moments merge_parts(std::vector<double> x, std::vector<std::uint64_t> sizes);

/// 1.6: of the pairs (x[i], y[i]).
double covariance(std::vector<double> x, std::vector<double> y);

/// 1.7: of a table, row by row.
double dependence(std::vector<double> joint, std::uint64_t columns);

/// 1.8: of the values x.
Moments moments(std::vector<double> x);

/// For plots: the variance by task 1.`task` (2, 3, 4, 5 or 8) of each part of x, `size` values
/// long; what is left over at the end is not a part. Task 5 adds to parts of 64 and merges them.
std::vector<double> variances(unsigned task, std::vector<double> x, std::uint64_t size);

/// For timing: the mean of `rounds` variances by task 1.`task` over x, in which each round but the
/// first changes one value: changes(seed) gives two numbers a round, and x[first % n] becomes what
/// x[second % n] was in the beginning. So no round can be answered from the one before.
double repeat(unsigned task, std::vector<double> x, std::uint64_t rounds, std::uint64_t seed);

/// The same over n values from 1e9 to 1e9 + 1 that are made here: lists that no wire would carry.
double repeat_made(unsigned task, std::uint64_t n, std::uint64_t rounds, std::uint64_t seed);

}  // namespace mc::experiments
