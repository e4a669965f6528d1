// mistake: leaves the power at k = 0 in ring 0
// caught by: 4.5 the mean over each ring
// hint: the mean of the points is still in here
#include "blue_noise.hpp"
#define radial_power right_radial_power
#include "solutions/blue_noise.cpp"
#undef radial_power

namespace mc {

std::vector<double> radial_power(std::span<const double> power, int kmax) {
  std::vector<double> rings = right_radial_power(power, kmax);
  rings[0] = power[power.size() / 2];
  return rings;
}

}  // namespace mc
