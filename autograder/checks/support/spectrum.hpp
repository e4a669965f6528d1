#pragma once
// Spectra of point sets, as the judge sees them.

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>
#include <vector>

namespace mc::checks {

/// A periodogram: the power at (kx, ky), abs(sum of exp(-2 pi i k.x))^2 / N, for both from -kmax to
/// kmax.
struct Spectrum {
  int kmax = 0;
  std::vector<double> power;  ///< ky outer

  double at(int kx, int ky) const {
    return power[static_cast<std::size_t>((ky + kmax) * (2 * kmax + 1) + kx + kmax)];
  }
};

/// By the definition, of waves along x times waves along y. Wave k is the product of k first waves,
/// right to 10 k eps: for averages over sets, which have three digits.
Spectrum spectrum_of(std::span<const double> x, std::span<const double> y, int kmax);

/// The power that jittered points, one in each of side x side cells, have on average at k: 1 -
/// sinc(kx / side)^2 sinc(ky / side)^2. A cell's mean wave has the size sinc sinc; what cells have
/// in common cancels, each cell's own remainder does not.
inline double jittered_power(int kx, int ky, int side) {
  const auto sinc = [&](int k) {
    const double turn = std::numbers::pi * k / side;
    return k == 0 ? 1 : std::sin(turn) / turn;
  };
  return 1 - std::pow(sinc(kx) * sinc(ky), 2);
}

/// The mean power over 0 < abs(k) <= sqrt(n)/2: the low band, where blue noise has little.
inline double low_band(const Spectrum& spectrum, double n) {
  double sum = 0, count = 0;
  for (int ky = -spectrum.kmax; ky <= spectrum.kmax; ++ky) {
    for (int kx = -spectrum.kmax; kx <= spectrum.kmax; ++kx) {
      const int squared = kx * kx + ky * ky;
      if (squared == 0 || 4 * squared > n) continue;
      sum += spectrum.at(kx, ky);
      ++count;
    }
  }
  return sum / count;
}

/// The largest mean power over rings of width sqrt(n)/20, up to 2 sqrt(n).
inline double peak(const Spectrum& spectrum, double n) {
  const double width = std::sqrt(n) / 20;
  std::vector<double> sum(40), count(40);
  for (int ky = -spectrum.kmax; ky <= spectrum.kmax; ++ky) {
    for (int kx = -spectrum.kmax; kx <= spectrum.kmax; ++kx) {
      const auto ring = static_cast<std::size_t>(std::sqrt(kx * kx + ky * ky) / width);
      if (ring >= sum.size() || (kx == 0 && ky == 0)) continue;
      sum[ring] += spectrum.at(kx, ky);
      ++count[ring];
    }
  }
  double most = 0;
  for (std::size_t ring = 0; ring < sum.size(); ++ring) {
    if (count[ring] > 0) most = std::max(most, sum[ring] / count[ring]);
  }
  return most;
}

}  // namespace mc::checks
