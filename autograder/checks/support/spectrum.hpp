#pragma once
// Spectra of point sets, as the judge sees them.

#include <algorithm>
#include <cmath>
#include <complex>
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

/// By the definition, of waves along x times waves along y. Each wave is computed from the
/// fractional part of k x, so it is right to 2 kmax eps.
inline Spectrum spectrum_of(std::span<const double> x, std::span<const double> y, int kmax) {
  const auto side = static_cast<std::size_t>(2 * kmax + 1);
  std::vector<std::complex<double>> sum(side * side), along(side);
  const auto wave = [](int k, double position) {
    const double turns = k * position;
    return std::polar(1.0, -2 * std::numbers::pi * (turns - std::round(turns)));
  };
  for (std::size_t p = 0; p < x.size(); ++p) {
    for (int k = 0; k <= kmax; ++k) {
      along[static_cast<std::size_t>(kmax + k)] = wave(k, x[p]);
      along[static_cast<std::size_t>(kmax - k)] =
          std::conj(along[static_cast<std::size_t>(kmax + k)]);
    }
    for (int k = 0; k <= kmax; ++k) {
      const std::complex<double> up = wave(k, y[p]);
      std::complex<double>* const row = &sum[static_cast<std::size_t>(k + kmax) * side];
      for (std::size_t i = 0; i < side; ++i) {
        row[i] += std::complex<double>(up.real() * along[i].real() - up.imag() * along[i].imag(),
                                       up.real() * along[i].imag() + up.imag() * along[i].real());
      }
    }
  }
  Spectrum spectrum{kmax, std::vector<double>(side * side)};
  for (std::size_t k = side * side / 2 - static_cast<std::size_t>(kmax); k < side * side; ++k) {
    spectrum.power[k] = std::norm(sum[k]) / static_cast<double>(x.size());
    spectrum.power[side * side - 1 - k] = spectrum.power[k];
  }
  return spectrum;
}

/// The mean power over low <= abs(k) < high, k = 0 left out. NaN where there is no such k.
inline double mean_power(const Spectrum& spectrum, double low, double high) {
  double sum = 0, count = 0;
  for (int ky = -spectrum.kmax; ky <= spectrum.kmax; ++ky) {
    for (int kx = -spectrum.kmax; kx <= spectrum.kmax; ++kx) {
      const double k = std::hypot(kx, ky);
      if (k == 0 || k < low || k >= high) continue;
      sum += spectrum.at(kx, ky);
      ++count;
    }
  }
  return sum / count;
}

/// The mean power over 0 < abs(k) <= sqrt(n)/2: the low band, where blue noise has little.
inline double low_band(const Spectrum& spectrum, double n) {
  return mean_power(spectrum, 0, std::nextafter(std::sqrt(n) / 2, n));
}

/// The largest mean power over rings of width sqrt(n)/20, up to 2 sqrt(n).
inline double peak(const Spectrum& spectrum, double n) {
  const double width = std::sqrt(n) / 20;
  std::vector<double> sum(40), count(40);
  for (int ky = -spectrum.kmax; ky <= spectrum.kmax; ++ky) {
    for (int kx = -spectrum.kmax; kx <= spectrum.kmax; ++kx) {
      const auto ring = static_cast<std::size_t>(std::hypot(kx, ky) / width);
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
