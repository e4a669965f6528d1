#pragma once
// What lab 2 measures of a submission. Where an experiment has a seed, its numbers come from one
// Rng(seed), and replicates are drawn from it one after the other.

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

/// An estimate, and how often the integrand was evaluated for it.
struct Counted {
  double value = 0, standard_error = 0;
  std::uint64_t n = 0;
  std::uint64_t evaluations = 0;
};
MC_FIELDS(Counted, value, standard_error, n, evaluations)

/// Estimates, one after the other from one generator, and what the integrand saw of them all.
struct Traces {
  std::vector<Estimate> estimates;
  std::vector<double> points;  ///< where g was evaluated, coordinate by coordinate
  std::vector<double> values;  ///< g there
};
MC_FIELDS(Traces, estimates, points, values)

/// The same with a density: each u that it made a sample of, and what there is at that.
struct ImportanceTraces {
  std::vector<Counted> estimates;
  std::vector<double> u;
  std::vector<double> points;     ///< x = p.sample(u)
  std::vector<double> values;     ///< g(x)
  std::vector<double> densities;  ///< p.pdf(x)
};
MC_FIELDS(ImportanceTraces, estimates, u, points, values, densities)

/// Confidence intervals, and the values of g that they were computed from.
struct IntervalTraces {
  std::vector<Interval> intervals;
  std::vector<double> values;
};
MC_FIELDS(IntervalTraces, intervals, values)

/// What the functions of lab 1 make of a list of values; NaN where one is not written yet.
struct ByLab1 {
  double mean = 0, variance_textbook = 0, variance_two_pass = 0;
  double mean_of_add = 0, variance_of_add = 0;
  double mean_of_moments = 0, variance_of_moments = 0;
};
MC_FIELDS(ByLab1, mean, variance_textbook, variance_two_pass, mean_of_add, variance_of_add,
          mean_of_moments, variance_of_moments)

/// 2.1: of each word.
std::vector<double> to_unit(std::vector<std::uint64_t> words);

/// 2.2: replicates of n samples each; the same looked at closely; and one estimate for each
/// integrand, from its own generator, in one process.
std::vector<Counted> estimates(Function g, std::uint64_t n, std::uint64_t seed,
                               std::uint64_t replicates);
Traces traces(Function g, std::uint64_t n, std::uint64_t seed, std::uint64_t replicates);
std::vector<Estimate> estimates_in_turn(std::vector<Function> g, std::uint64_t n,
                                        std::vector<std::uint64_t> seeds);
ByLab1 by_lab_1(std::vector<double> values);

/// 2.3: at each u, at each x.
std::vector<double> sample_exponential(std::vector<double> u, double rate);
std::vector<double> sample_power(std::vector<double> u, double a);
std::vector<double> pdf_exponential(std::vector<double> x, double rate);
std::vector<double> pdf_power(std::vector<double> x, double a);

/// 2.4: as 2.2, with a density.
std::vector<Counted> importance_estimates(Function g, Sampling p, std::uint64_t n,
                                          std::uint64_t seed, std::uint64_t replicates);
ImportanceTraces importance_traces(Function g, Sampling p, std::uint64_t n, std::uint64_t seed,
                                   std::uint64_t replicates);

/// 2.5: of one estimate; of replicates of 2.2; and of those with what they saw.
Interval confidence_interval(Estimate estimate, double level);
std::vector<Interval> confidence_intervals(Function g, std::uint64_t n, double level,
                                           std::uint64_t seed, std::uint64_t replicates);
IntervalTraces interval_traces(Function g, std::uint64_t n, double level, std::uint64_t seed,
                               std::uint64_t replicates);

/// 2.6
std::uint64_t samples_for(Estimate pilot, double target_error);

/// 2.7: replicates of n samples each.
std::vector<Estimate> irradiance_area(RectLight light, std::uint64_t n, std::uint64_t seed,
                                      std::uint64_t replicates);
std::vector<Estimate> irradiance_hemisphere(RectLight light, std::uint64_t n, std::uint64_t seed,
                                            std::uint64_t replicates);

/// 2.8: calls for these many numbers, one after the other, all of them, in a span that holds
/// `before` everywhere; a call for `size` numbers from the generator of each seed, in one process;
/// the first number of each of `calls` calls for `size`, one after the other from one generator;
/// and `size` numbers from a generator that only knows one word.
std::vector<double> uniforms(std::uint64_t seed, std::vector<std::uint64_t> sizes, double before);
std::vector<double> uniforms_in_turn(std::vector<std::uint64_t> seeds, std::uint64_t size);
std::vector<double> first_uniforms(std::uint64_t seed, std::uint64_t size, std::uint64_t calls);
std::vector<double> uniforms_constant(std::uint64_t word, std::uint64_t size);

/// Means of `size` numbers made by a source: 0 std::mt19937_64 and std::uniform_real_distribution,
/// 1 to_unit(rng()) number by number, 2 uniforms.
std::vector<double> means_of(unsigned source, std::uint64_t size, std::uint64_t seed,
                             std::uint64_t replicates);

/// For timing: `size` numbers by a source, `rounds` times; round r has its own generator, of
/// seed `seed` + r (but source 0, whose seeding takes long: one for all). The last number. And 2.7
/// by way of the area (0) or the hemisphere (1) with n samples, `rounds` times: the last estimate.
double repeat_source(unsigned source, std::uint64_t size, std::uint64_t rounds, std::uint64_t seed);
double repeat_irradiance(unsigned way, std::uint64_t n, std::uint64_t rounds);

}  // namespace mc::experiments
