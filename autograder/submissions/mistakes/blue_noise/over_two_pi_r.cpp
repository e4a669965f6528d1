// mistake: divides by the length of a ring, not by how many frequencies it has
// caught by: 4.5 the mean over each ring
// hint: this is the sum over 2 pi r
#include "blue_noise.hpp"
#define radial_power right_radial_power
#include "solutions/blue_noise.cpp"
#undef radial_power

namespace mc {

std::vector<double> radial_power(std::span<const double> power, int kmax) {
  std::vector<double> rings = right_radial_power(power, kmax);
  rings.assign(rings.size(), 0);
  std::size_t i = 0;
  for (int ky = -kmax; ky <= kmax; ++ky) {
    for (int kx = -kmax; kx <= kmax; ++kx, ++i) {
      const auto ring = static_cast<std::size_t>(std::lround(std::hypot(kx, ky)));
      if (ring >= rings.size()) continue;
      rings[ring] += power[i];
    }
  }
  for (std::size_t ring = 1; ring < rings.size(); ++ring) {
    rings[ring] /= 2 * std::numbers::pi * static_cast<double>(ring);
  }
  rings[0] = std::numeric_limits<double>::quiet_NaN();
  return rings;
}

}  // namespace mc
