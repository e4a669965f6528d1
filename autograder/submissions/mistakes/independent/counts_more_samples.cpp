// mistake: says how many more samples it takes, not how many
// caught by: 2.6 the samples
// hint: all of them are asked for, not how many more
#include "independent.hpp"

#define samples_for right_samples_for
#include "solutions/independent.cpp"
#undef samples_for

namespace mc {

std::uint64_t samples_for(const Estimate& pilot, double target_error) {
  right_samples_for(pilot, target_error);  // for what it refuses
  const double ratio = pilot.standard_error / target_error;
  const double n = static_cast<double>(pilot.n) * ratio * ratio;
  const double more = std::ceil(n - static_cast<double>(pilot.n));
  return static_cast<std::uint64_t>(std::max(1.0, more));
}

}  // namespace mc
