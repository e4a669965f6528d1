#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>

namespace mc {

/// A function on the unit cube, to be integrated: f takes a point of `dims` coordinates in [0,1).
struct Integrand {
  std::size_t dims = 1;
  std::function<double(std::span<const double>)> f;
};

/// What a Monte Carlo estimator gives back.
struct Estimate {
  double value = 0;           ///< of the integral
  double standard_error = 0;  ///< of `value`: its standard deviation, as estimated from the samples
  std::uint64_t n = 0;        ///< evaluations of the integrand
};

struct Interval {
  double low = 0, high = 0;
};

/// A probability density on the line.
struct Density {
  std::function<double(double)> sample;  ///< from u in [0,1) to x, by inversion
  std::function<double(double)> pdf;     ///< at x
};

}  // namespace mc
