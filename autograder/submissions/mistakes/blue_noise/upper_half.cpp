// mistake: looks at one half of the plane: the power of points is the same in the other, that of any
// mistake: list is not
// caught by: 4.5 the mean over each ring
// hint: this is the mean over ky >= 0 alone
#include "blue_noise.hpp"
#define radial_power right_radial_power
#include "solutions/blue_noise.cpp"
#undef radial_power

namespace mc {

std::vector<double> radial_power(std::span<const double> power, int kmax) {
  std::vector<double> rings = right_radial_power(power, kmax);
  std::vector<double> count(rings.size());
  rings.assign(rings.size(), 0);
  std::size_t i = 0;
  for (int ky = -kmax; ky <= kmax; ++ky) {
    for (int kx = -kmax; kx <= kmax; ++kx, ++i) {
      const auto ring = static_cast<std::size_t>(std::lround(std::hypot(kx, ky)));
      if (ring >= rings.size() || ky < 0) continue;
      rings[ring] += power[i];
      ++count[ring];
    }
  }
  for (std::size_t ring = 0; ring < rings.size(); ++ring) rings[ring] /= count[ring];
  rings[0] = std::numeric_limits<double>::quiet_NaN();
  return rings;
}

}  // namespace mc
