// mistake: the number of samples is rounded to the nearest
// caught by: 2.6 the samples
// hint: this many do not quite do it: round up
#include "independent.hpp"

#define samples_for right_samples_for
#include "solutions/independent.cpp"
#undef samples_for

namespace mc {

std::uint64_t samples_for(const Estimate& pilot, double target_error) {
  right_samples_for(pilot, target_error);  // for what it refuses
  const double ratio = pilot.standard_error / target_error;
  const double n = static_cast<double>(pilot.n) * ratio * ratio;
  return std::max<std::uint64_t>(1, static_cast<std::uint64_t>(std::round(n)));
}

}  // namespace mc
