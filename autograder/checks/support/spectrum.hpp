#pragma once
// Spectra of point sets.

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

namespace mc::checks {

/// A periodogram: the power |sum of exp(-2 pi i k.x)|^2 / N at k in [-kmax, kmax]^2.
struct Spectrum {
  int kmax = 0;
  std::vector<double> power;  ///< ky outer

  double at(int kx, int ky) const {
    return power[static_cast<std::size_t>((ky + kmax) * (2 * kmax + 1) + kx + kmax)];
  }
};

/// By the definition, with products of waves along x and along y. Wave k is a power of wave 1,
/// accurate to 10 k eps, which is enough for averages over sets.
Spectrum spectrum_of(std::span<const double> x, std::span<const double> y, int kmax);

/// Sums of the power over rings of k, and their numbers of terms. Rings from `rings` on are
/// ignored.
struct Rings {
  std::vector<double> sum, count;
};
template <class RingOf>
Rings rings_of(const Spectrum& spectrum, std::size_t rings, RingOf ring_of) {
  Rings all{std::vector<double>(rings), std::vector<double>(rings)};
  for (int ky = -spectrum.kmax; ky <= spectrum.kmax; ++ky) {
    for (int kx = -spectrum.kmax; kx <= spectrum.kmax; ++kx) {
      const double ring = ring_of(kx, ky);
      if (ring >= static_cast<double>(rings)) continue;
      all.sum[static_cast<std::size_t>(ring)] += spectrum.at(kx, ky);
      ++all.count[static_cast<std::size_t>(ring)];
    }
  }
  return all;
}

/// The mean power over 0 < |k| <= sqrt(n)/2: the low band, where blue noise has little.
inline double low_band(const Spectrum& spectrum, double n) {
  const Rings one = rings_of(spectrum, 1, [=](int kx, int ky) {
    const int squared = kx * kx + ky * ky;
    return squared == 0 || 4 * squared > n ? 1 : 0;
  });
  return one.sum[0] / one.count[0];
}

/// The largest mean power over rings of width sqrt(n)/20, up to 2 sqrt(n).
inline double peak(const Spectrum& spectrum, double n) {
  const Rings all = rings_of(spectrum, 40, [=](int kx, int ky) {
    return kx == 0 && ky == 0 ? 40 : std::hypot(kx, ky) / (std::sqrt(n) / 20);
  });
  double most = 0;
  for (std::size_t ring = 0; ring < 40; ++ring) {
    if (all.count[ring] > 0) most = std::max(most, all.sum[ring] / all.count[ring]);
  }
  return most;
}

}  // namespace mc::checks
