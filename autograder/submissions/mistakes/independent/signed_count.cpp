// mistake: the number of samples goes through a signed integer
// caught by: 2.6 at least one
// hint: rounded up
#include "independent.hpp"

#define samples_for right_samples_for
#include "solutions/independent.cpp"
#undef samples_for

namespace mc {

std::uint64_t samples_for(const Estimate& pilot, double target_error) {
  right_samples_for(pilot, target_error);  // for what it refuses
  const double ratio = pilot.standard_error / target_error;
  const double n = static_cast<double>(pilot.n) * ratio * ratio;
  const double most = 0x1.fffffffffffffp62;
  return static_cast<std::uint64_t>(
      std::max<std::int64_t>(1, static_cast<std::int64_t>(std::min(std::ceil(n), most))));
}

}  // namespace mc
