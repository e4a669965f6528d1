// mistake: the samples for a target grow with the ratio of the errors, not its square
// caught by: 2.6 the samples that bring the error down
// caught by: 2.6 at least one sample
// hint: square the ratio
#include "independent.hpp"

#define samples_for right_samples_for
#include "solutions/independent.cpp"
#undef samples_for

namespace mc {

std::uint64_t samples_for(const Estimate& pilot, double target_error) {
  right_samples_for(pilot, target_error);  // for what it refuses
  const double ratio = pilot.standard_error / target_error;
  return std::max<std::uint64_t>(
      1, static_cast<std::uint64_t>(std::ceil(static_cast<double>(pilot.n) * ratio)));
}

}  // namespace mc
