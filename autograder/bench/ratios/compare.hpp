#pragma once
// The project's ratios, measured in one process: the reference solutions against the strongest code
// that a good engineer writes in ten lines, and against the library that one would call instead.
// Nothing else may run between the two sides, because the differences are tenths of a nanosecond.

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace mc::ratios {

/// All output goes to the same 32 KB (except for «out of cache»), as a library writes every point
/// to the same few bytes: this times the generation of numbers, not their storage.
constexpr std::size_t block = 4096;

/// Every measured function stores a result here, so that the compiler cannot remove it.
extern volatile double sink;

using Work = std::function<void()>;

struct Opponent {
  std::string name;
  Work work;
  double wanted = 0;  ///< the ratio that the project aims for; 0: none
};

/// Interleaved rounds against each opponent, the best of fifteen on either side; the median of five
/// such ratios. Prints a row for each: name, against, wanted, ratio, nanoseconds per value of ours,
/// of the other; tab-separated. One call of any side makes `values` numbers.
void compare(const std::string& name, double values, const Work& ours,
             const std::vector<Opponent>& opponents);

}  // namespace mc::ratios
