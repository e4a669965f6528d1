// Mistakes in task 4.5.
#include "blue_noise.hpp"

#define radial_power right_radial_power
#include "solutions/blue_noise.cpp"
#undef radial_power

// mistake: counts the corners in the last ring
// hint: the corners are in the last ring
namespace mc::corners_kept {
std::vector<double> radial_power(std::span<const double> power, int kmax) {
  std::vector<double> rings = right_radial_power(power, kmax);
  std::vector<double> count(rings.size());
  rings.assign(rings.size(), 0);
  std::size_t i = 0;
  for (int ky = -kmax; ky <= kmax; ++ky) {
    for (int kx = -kmax; kx <= kmax; ++kx, ++i) {
      const auto rounded = static_cast<std::size_t>(std::lround(std::hypot(kx, ky)));
      const std::size_t ring = std::min(rounded, rings.size() - 1);
      if (ring >= rings.size()) continue;
      rings[ring] += power[i];
      ++count[ring];
    }
  }
  for (std::size_t ring = 0; ring < rings.size(); ++ring) rings[ring] /= count[ring];
  rings[0] = std::numeric_limits<double>::quiet_NaN();
  return rings;
}
}  // namespace mc::corners_kept

// mistake: leaves the power at k = 0 in ring 0
// hint: ring 0 has the power at k = 0
namespace mc::mean_left_in {
std::vector<double> radial_power(std::span<const double> power, int kmax) {
  std::vector<double> rings = right_radial_power(power, kmax);
  rings[0] = power[power.size() / 2];
  return rings;
}
}  // namespace mc::mean_left_in

// mistake: divides by the length of a ring, not by its number of frequencies
// hint: this is the sum over 2 pi r
namespace mc::over_two_pi_r {
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
}  // namespace mc::over_two_pi_r

// mistake: truncates abs(k) instead of rounding it
// hint: |k| is truncated
namespace mc::rings_cut {
std::vector<double> radial_power(std::span<const double> power, int kmax) {
  std::vector<double> rings = right_radial_power(power, kmax);
  std::vector<double> count(rings.size());
  rings.assign(rings.size(), 0);
  std::size_t i = 0;
  for (int ky = -kmax; ky <= kmax; ++ky) {
    for (int kx = -kmax; kx <= kmax; ++kx, ++i) {
      const auto ring = static_cast<std::size_t>(std::hypot(kx, ky));
      if (ring >= rings.size()) continue;
      rings[ring] += power[i];
      ++count[ring];
    }
  }
  for (std::size_t ring = 0; ring < rings.size(); ++ring) rings[ring] /= count[ring];
  rings[0] = std::numeric_limits<double>::quiet_NaN();
  return rings;
}
}  // namespace mc::rings_cut

// mistake: sums each ring without taking the mean
// hint: this is the sum over the ring
namespace mc::sum_over_rings {
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
  rings[0] = std::numeric_limits<double>::quiet_NaN();
  return rings;
}
}  // namespace mc::sum_over_rings

// mistake: computes one half of the plane and mirrors it: true for points, but not for any list
// hint: this is the mean over ky >= 0 only
namespace mc::upper_half {
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
}  // namespace mc::upper_half
