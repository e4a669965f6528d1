#pragma once
// The project's ratios, measured in one process: the reference solutions against what one would
// write first, or call instead. Nothing else may run between the two sides, because the differences
// are tenths of a nanosecond. A file here has the ratios of a lab, or of a library if installed.

#include <cstddef>
#include <functional>
#include <string>

namespace mc::ratios {

/// All output goes to the same 32 KB (except for «out of cache»), as a library writes every point
/// to the same few bytes: this times the generation of numbers, not their storage.
constexpr std::size_t block = 4096;

/// Every measured function stores a result here, so that the compiler cannot remove it.
extern volatile double sink;

struct Ratio {
  std::string name;     ///< what is timed
  std::string against;  ///< against what
  double wanted = 0;    ///< the ratio that the project aims for; 0: none
  double values = 1;    ///< numbers made by one call of either side
};

/// Interleaved rounds, the best of fifteen on either side; the median of five such ratios. Prints a
/// row: name, against, wanted, ratio, nanoseconds per value of ours, of the other; tab-separated.
void compare(const Ratio& ratio, const std::function<void()>& ours,
             const std::function<void()>& other);

/// A file's measurements, which main() runs in the order of `place`.
struct Measurements {
  Measurements(int place, void (*measure)());
};

}  // namespace mc::ratios
