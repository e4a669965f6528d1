#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>

namespace mc {

/// A function on the unit cube. `f` takes one point: a span of `dims` coordinates, each in [0,1).
struct Integrand {
  std::size_t dims = 1;
  std::function<double(std::span<const double>)> f;
};

/// What a Monte Carlo estimator returns.
struct Estimate {
  double value = 0;           ///< the estimate of the integral
  double standard_error = 0;  ///< an estimate of the standard deviation of `value`
  std::uint64_t n = 0;        ///< number of evaluations of the integrand
};

/// The interval from `low` to `high`.
struct Interval {
  double low = 0, high = 0;
};

/// A probability density on the line, and a way to sample it.
struct Density {
  std::function<double(double)> sample;  ///< the quantile function: maps u in [0,1) to x
  std::function<double(double)> pdf;     ///< the density at x
};

}  // namespace mc
