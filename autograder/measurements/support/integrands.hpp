#pragma once
// What points are to integrate: functions of known mean, from the kindest to the least kind. Plots
// and benchmark read this table.

#include <functional>
#include <limits>
#include <span>
#include <string>
#include <vector>

#include "measurements/support/error_sums.hpp"
#include "measurements/support/methods.hpp"

namespace mc::measurements {

struct Integrand {
  std::string name;     ///< "smooth 2D"
  std::string formula;  ///< "exp(x + y)"
  std::size_t dims;
  double mean;
  std::function<double(std::span<const double>)> g;  ///< at one point
  /// Of one value at a uniform point, where known.
  double variance = std::numeric_limits<double>::quiet_NaN();
  bool in_bench = false;
};

const std::vector<Integrand>& integrands();
const Integrand& integrand(const std::string& name);

/// The mean of the values at the first n points, less the exact one; of dimensions `first`, ….
double error_of(const Integrand& integrand, const PointSet& points, std::size_t n,
                std::size_t first = 0);
inline double error_of(const Integrand& integrand, const PointSet& points) {
  return error_of(integrand, points, points.size());
}

/// What a value costs, in nanoseconds of this process: the integrand is ours, so it is timed here.
double nanoseconds_of(const Integrand& integrand);

/// Errors of a method on `integrands`, which have the same dimensions, over the first `used` (0:
/// all) of n points; none where the method has none. A measurement carries two million coordinates.
std::vector<ErrorSums> errors_of(const Method& method, const std::vector<Integrand>& integrands,
                                 std::uint64_t n, std::uint64_t replicates, std::uint64_t seed,
                                 std::uint64_t used = 0);
ErrorSums errors_of(const Method& method, const Integrand& integrand, std::uint64_t n,
                    std::uint64_t replicates, std::uint64_t seed, std::uint64_t used = 0);

}  // namespace mc::measurements
