#pragma once
// The experiments of lab 1: what is run and measured in a submission.

#include <cstdint>
#include <vector>

#include "runner/wire.hpp"
#include "variance.hpp"

namespace mc {
MC_FIELDS(Moments, count, mean, m2)
}  // namespace mc

namespace mc::experiments {

/// 1.1, 1.2, 1.3: the mean and the sample variances of x.
double mean(std::vector<double> x);
double variance_textbook(std::vector<double> x);
double variance_two_pass(std::vector<double> x);

/// 1.3: for each of `constants`, the variance of n values equal to it.
std::vector<double> two_pass_of_constants(std::vector<double> constants, std::uint64_t n);

/// 1.4: the moments after one add() per value of x, in order; and variance() of the given moments.
Moments welford(std::vector<double> x);
double variance_of(Moments moments);

/// 1.4: the moments after `count` calls of add(), starting from `moments`. The values are those of
/// x in order, repeated as often as needed.
Moments stream(Moments moments, std::vector<double> x, std::uint64_t count);

/// 1.5: the merged moments of `a` and `b`; and the moments of x computed in consecutive parts of
/// the given sizes, each of which is merged into the result so far.
Moments merge(Moments a, Moments b);
Moments merge_parts(std::vector<double> x, std::vector<std::uint64_t> sizes);

/// 1.6: the covariance of the pairs (x[i], y[i]).
double covariance(std::vector<double> x, std::vector<double> y);

/// 1.7: the dependence of a joint table, stored row by row, `columns` weights per row.
double dependence(std::vector<double> joint, std::uint64_t columns);

/// 1.8: the moments of x.
Moments moments(std::vector<double> x);

/// For plots: splits x into parts of `size` values, drops an incomplete part at the end, and
/// returns the variance of each part, computed by task 1.`task` (2, 3, 4, 5 or 8). Task 5 merges
/// the moments of parts of 64 values.
std::vector<double> variances(unsigned task, std::vector<double> x, std::uint64_t size);

/// For timing: the mean of `rounds` variances of x, computed by task 1.`task`. Each round except
/// the first changes one value: it draws two numbers a and b from Rng(seed), and x[a % n] receives
/// the original value of x[b % n]. So no round can reuse the result of the round before it.
double repeat(unsigned task, std::vector<double> x, std::uint64_t rounds, std::uint64_t seed);

/// The same for n values between 1e9 and 1e9 + 1. They are generated here, because lists this long
/// would not fit into a request.
double repeat_made(unsigned task, std::uint64_t n, std::uint64_t rounds, std::uint64_t seed);

}  // namespace mc::experiments
