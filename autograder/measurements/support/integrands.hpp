#pragma once
// What points are to integrate: functions of known mean, from the kindest to the least kind. Plots
// and benchmark read this table.

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "measurements/support/error_sums.hpp"
#include "measurements/support/methods.hpp"

namespace mc::measurements {

struct Integrand {
  std::string name;  ///< "smooth 2D"
  std::size_t dims;
  double mean;
  std::function<double(View)> g;  ///< at one point
  double variance = missing;      ///< of one value at a uniform point, where known
  bool in_bench = false;
};

const std::vector<Integrand>& integrands();
const Integrand& integrand(const std::string& name);

/// The mean of the values at the first n points, less the exact one; of dimensions `first`, ….
double error_of(const Integrand& integrand, const PointSet& points, std::size_t n,
                std::size_t first = 0);

/// What a value costs, in nanoseconds of this process: the integrand is ours, so it is timed here.
double nanoseconds_of(const Integrand& integrand);

/// Errors over the first n points of each set, in dimensions `first`, ….
ErrorSums errors_of(const Sets& sets, const Integrand& integrand, std::size_t n,
                    std::size_t first = 0);

/// Errors of a method on `integrands`, which have the same dimensions, over the first `used` (0:
/// all) of n points; none where the method has none.
std::vector<ErrorSums> errors_of(const Method& method, const std::vector<Integrand>& integrands,
                                 Count n, Count replicates, Count seed, Count used = 0);
ErrorSums errors_of(const Method& method, const Integrand& integrand, Count n, Count replicates,
                    Count seed, Count used = 0);

}  // namespace mc::measurements
