// Mistakes in task 4.5.
#include "blue_noise.hpp"

#define radial_power right_radial_power
#include "solutions/blue_noise.cpp"
#undef radial_power

namespace mc {
namespace {

constexpr std::size_t no_ring = ~std::size_t{0};

std::size_t rounded(int kx, int ky) {
  return static_cast<std::size_t>(std::lround(std::hypot(kx, ky)));
}

/// The sums and the counts of rings, ring_of(kx, ky) the ring of a frequency; beyond kmax: none.
struct Rings {
  std::vector<double> sum, count;
};
template <class RingOf>
Rings rings_by(std::span<const double> power, int kmax, RingOf ring_of) {
  right_radial_power(power, kmax);  // for its exceptions
  Rings rings;
  rings.sum.resize(static_cast<std::size_t>(kmax) + 1);
  rings.count.resize(rings.sum.size());
  std::size_t i = 0;
  for (int ky = -kmax; ky <= kmax; ++ky) {
    for (int kx = -kmax; kx <= kmax; ++kx, ++i) {
      const std::size_t ring = ring_of(kx, ky);
      if (ring >= rings.sum.size()) continue;
      rings.sum[ring] += power[i];
      ++rings.count[ring];
    }
  }
  rings.sum[0] = std::numeric_limits<double>::quiet_NaN();
  return rings;
}

std::vector<double> means(Rings rings) {
  for (std::size_t r = 0; r < rings.sum.size(); ++r) rings.sum[r] /= rings.count[r];
  return rings.sum;
}

}  // namespace
}  // namespace mc

// mistake: counts the corners in the last ring
// hint: the corners are in the last ring
namespace mc::corners_kept {
std::vector<double> radial_power(std::span<const double> power, int kmax) {
  return means(rings_by(power, kmax, [=](int kx, int ky) {
    return std::min(rounded(kx, ky), static_cast<std::size_t>(kmax));
  }));
}
}  // namespace mc::corners_kept

// mistake: writes 0 for ring 0
// hint: ring 0 is 0: it must be NaN
namespace mc::zero_in_ring_0 {
std::vector<double> radial_power(std::span<const double> power, int kmax) {
  std::vector<double> rings = right_radial_power(power, kmax);
  rings[0] = 0;
  return rings;
}
}  // namespace mc::zero_in_ring_0

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
  std::vector<double> sum = rings_by(power, kmax, rounded).sum;
  for (std::size_t r = 1; r < sum.size(); ++r)
    sum[r] /= 2 * std::numbers::pi * static_cast<double>(r);
  return sum;
}
}  // namespace mc::over_two_pi_r

// mistake: truncates abs(k) instead of rounding it
// hint: |k| is truncated
namespace mc::rings_cut {
std::vector<double> radial_power(std::span<const double> power, int kmax) {
  return means(rings_by(
      power, kmax, [](int kx, int ky) { return static_cast<std::size_t>(std::hypot(kx, ky)); }));
}
}  // namespace mc::rings_cut

// mistake: sums each ring without taking the mean
// hint: this is the sum over the ring
namespace mc::sum_over_rings {
std::vector<double> radial_power(std::span<const double> power, int kmax) {
  return rings_by(power, kmax, rounded).sum;
}
}  // namespace mc::sum_over_rings

// mistake: computes one half of the plane and mirrors it: true for points, but not for any list
// hint: this is the mean over ky >= 0 only
namespace mc::upper_half {
std::vector<double> radial_power(std::span<const double> power, int kmax) {
  return means(
      rings_by(power, kmax, [](int kx, int ky) { return ky < 0 ? no_ring : rounded(kx, ky); }));
}
}  // namespace mc::upper_half
