#pragma once
// The project's ratios, measured in one process: the reference solutions against what one would
// write first, or call instead. Nothing else may run between the two sides, because the differences
// are tenths of a nanosecond. A file here has the ratios of a lab, or of a library if installed.

#include <cstddef>
#include <functional>
#include <string>

namespace mc::ratios {

/// What is made is made in the same 32 KB (but for «out of cache»), as a library makes every point
/// in the same few bytes: what is timed is making numbers, not storing them.
constexpr std::size_t block = 4096;

/// Whatever is measured leaves something here, so that it is computed.
extern volatile double sink;

struct Ratio {
  std::string name;     ///< what is timed
  std::string against;  ///< against what
  double wanted = 0;    ///< the ratio that the project aims for; 0: none
  double values = 1;    ///< numbers made by one call of either side
};

/// Interleaved rounds, the best of fifteen on either side; the median of five such ratios. Prints a
/// row: name, against, wanted, ratio, nanoseconds a value of ours, of the other; separated by tabs.
void compare(const Ratio& ratio, const std::function<void()>& ours,
             const std::function<void()>& other);

/// A file's measurements, made by main() in the order of `place`.
struct Measurements {
  Measurements(int place, void (*measure)());
};

}  // namespace mc::ratios
