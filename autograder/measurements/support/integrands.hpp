#pragma once
// What every sampler of the bench is asked to integrate: functions of known mean and variance, from
// the kindest to the least kind, each scaled to the mean 1, so that an error is a relative error.

#include <cstddef>
#include <span>
#include <string>

namespace mc::checks {

struct BenchIntegrand {
  std::string name;  ///< "smooth 2D"
  std::size_t dims;
  double variance;                       ///< of one value at a uniform point
  double (*g)(std::span<const double>);  ///< at one point
};

/// Six of them.
std::span<const BenchIntegrand> bench_integrands();

/// The mean of `integrand` over points that are given by their columns.
double mean_over(const BenchIntegrand& integrand, std::span<const std::span<const double>> columns);

/// What a value costs, in nanoseconds of this process: the integrand is ours, so it is timed here.
double nanoseconds_of(const BenchIntegrand& integrand);

}  // namespace mc::checks
