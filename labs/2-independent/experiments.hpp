#pragma once
// The experiments of lab 2: what is run and measured in a submission. An experiment with a seed
// draws all its random numbers from one Rng(seed), replicate after replicate.

#include <cstdint>
#include <vector>

#include "functions.hpp"
#include "independent.hpp"
#include "runner/wire.hpp"

namespace mc {
MC_FIELDS(Estimate, value, standard_error, n)
MC_FIELDS(Interval, low, high)
MC_FIELDS(RectLight, x0, x1, y0, y1, height, radiance)
}  // namespace mc

namespace mc::experiments {

/// An estimate and the number of evaluations of the integrand that it took.
struct CountedEstimate {
  double value = 0, standard_error = 0;
  std::uint64_t n = 0;
  std::uint64_t evaluations = 0;
};
MC_FIELDS(CountedEstimate, value, standard_error, n, evaluations)

/// Consecutive estimates from one generator, with every evaluation of the integrand.
struct Traces {
  std::vector<Estimate> estimates;
  std::vector<double> points;  ///< the points at which g was evaluated, point by point
  std::vector<double> values;  ///< g at these points
};
MC_FIELDS(Traces, estimates, points, values)

/// Consecutive importance-sampling estimates, with every sample that was drawn from the density p.
struct ImportanceTraces {
  std::vector<CountedEstimate> estimates;
  std::vector<double> u;          ///< the argument of p.sample
  std::vector<double> points;     ///< x = p.sample(u)
  std::vector<double> values;     ///< g(x)
  std::vector<double> densities;  ///< p.pdf(x)
};
MC_FIELDS(ImportanceTraces, estimates, u, points, values, densities)

/// Confidence intervals and the values of g from which they were computed.
struct IntervalTraces {
  std::vector<Interval> intervals;
  std::vector<double> values;
};
MC_FIELDS(IntervalTraces, intervals, values)

/// An estimate, and the variance of one of its samples.
struct ValueAndVariance {
  double value = 0, variance = 0;
};
MC_FIELDS(ValueAndVariance, value, variance)

/// 2.1: to_unit() of each word.
std::vector<double> to_unit(std::vector<std::uint64_t> words);

/// 2.2: `replicates` estimates of `g` from n samples each; and the same with every evaluation of g.
/// estimates_in_turn: one estimate per integrand, g[i] with the generator Rng(seeds[i]), all in one
/// process.
std::vector<CountedEstimate> estimates(Function g, std::uint64_t n, std::uint64_t seed,
                                       std::uint64_t replicates);
Traces traces(Function g, std::uint64_t n, std::uint64_t seed, std::uint64_t replicates);
std::vector<Estimate> estimates_in_turn(std::vector<Function> g, std::uint64_t n,
                                        std::vector<std::uint64_t> seeds);

/// 2.3: the quantile functions at each u, and the densities at each x.
std::vector<double> sample_exponential(std::vector<double> u, double rate);
std::vector<double> sample_power(std::vector<double> u, double a);
std::vector<double> pdf_exponential(std::vector<double> x, double rate);
std::vector<double> pdf_power(std::vector<double> x, double a);

/// 2.4: as in 2.2, but with samples from the density `p`.
std::vector<CountedEstimate> importance_estimates(Function g, Sampling p, std::uint64_t n,
                                                  std::uint64_t seed, std::uint64_t replicates);
ImportanceTraces importance_traces(Function g, Sampling p, std::uint64_t n, std::uint64_t seed,
                                   std::uint64_t replicates);

/// 2.5: the interval around the given estimate; the intervals around `replicates` estimates of 2.2;
/// and the same with the values of g.
Interval confidence_interval(Estimate estimate, double level);
std::vector<Interval> confidence_intervals(Function g, std::uint64_t n, double level,
                                           std::uint64_t seed, std::uint64_t replicates);
IntervalTraces interval_traces(Function g, std::uint64_t n, double level, std::uint64_t seed,
                               std::uint64_t replicates);

/// 2.6: the number of samples that reach `target_error`, according to the pilot run.
std::uint64_t samples_for(Estimate pilot, double target_error);

/// 2.7: `replicates` estimates from n samples each.
std::vector<Estimate> irradiance_area(RectLight light, std::uint64_t n, std::uint64_t seed,
                                      std::uint64_t replicates);
std::vector<Estimate> irradiance_hemisphere(RectLight light, std::uint64_t n, std::uint64_t seed,
                                            std::uint64_t replicates);

/// 2.9: `replicates` estimates from n pairs each. irradiance_ways: one estimate by each of `ways`,
/// 0 for points on the light, 1 for directions, 2 for pairs, all with the same seed; and the
/// variance of one sample or pair that it reports, n standard_error^2.
std::vector<Estimate> irradiance_combined(RectLight light, std::uint64_t n, std::uint64_t seed,
                                          std::uint64_t replicates);
std::vector<ValueAndVariance> irradiance_ways(std::vector<std::uint64_t> ways, RectLight light,
                                              std::uint64_t n, std::uint64_t seed);

/// 2.8, uniforms: all numbers of consecutive calls, one call for each of `sizes`; every value of a
/// span is `before` until the call. uniforms_in_turn: `size` numbers from Rng(seed) for each seed,
/// in one process. first_uniforms: the first number of each of `calls` consecutive calls for `size`
/// numbers. uniforms_constant: `size` numbers from Rng::constant(word).
std::vector<double> uniforms(std::uint64_t seed, std::vector<std::uint64_t> sizes, double before);
std::vector<double> uniforms_in_turn(std::vector<std::uint64_t> seeds, std::uint64_t size);
std::vector<double> first_uniforms(std::uint64_t seed, std::uint64_t size, std::uint64_t calls);
std::vector<double> uniforms_constant(std::uint64_t word, std::uint64_t size);

/// `replicates` means of `size` numbers each. The source of the numbers is 0 for std::mt19937_64
/// with std::uniform_real_distribution, 1 for to_unit(rng()) number by number, and 2 for
/// uniforms().
std::vector<double> means_of(unsigned source, std::uint64_t size, std::uint64_t seed,
                             std::uint64_t replicates);

/// For timing: makes `size` numbers `rounds` times and returns the last number. Round r uses a
/// generator with the seed `seed` + r; source 0, whose seeding is slow, uses one generator for all
/// rounds. repeat_irradiance: `rounds` estimates with n samples by this way; returns the last
/// value.
double repeat_source(unsigned source, std::uint64_t size, std::uint64_t rounds, std::uint64_t seed);
double repeat_irradiance(unsigned way, std::uint64_t n, std::uint64_t rounds);

}  // namespace mc::experiments
