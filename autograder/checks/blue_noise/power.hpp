#pragma once
// What power a periodogram must have, and how wrong it may be.

#include <cmath>
#include <numbers>

#include "checks/blue_noise/point_sets.hpp"

namespace mc::checks {

/// How wrong a periodogram may be. A wave's angle, 2 pi (kx x + ky y) <= 4 pi kmax, is rounded a
/// few times, and so a wave is wrong by less than 32 (kmax + 1) eps; n additions lose n eps of n
/// waves. So the sum of n waves is wrong by n delta, and its square over n by the two terms here.
inline double power_tolerance(double exact, double n, int kmax) {
  const double delta = (32.0 * (kmax + 1) + n) * eps;
  return 2 * std::sqrt(n * exact) * delta + n * delta * delta;
}

/// The power at k of two points that are (dx, dy) apart: abs(1 + exp(2 pi i k.d))^2 / 2, which is
/// 1 + cos(2 pi k.d), but that cancels where the waves do: 2 cos(pi k.d)^2. The product is exact in
/// 64 bits for |k| < 2^10.
inline double power_of_two(long double dx, long double dy, int kx, int ky) {
  const long double turns = kx * dx + ky * dy;
  const long double wave = std::cos(std::numbers::pi_v<long double> * (turns - std::round(turns)));
  return static_cast<double>(2 * wave * wave);
}

/// The definition in extended precision (where the machine has it): a spectrum that is right to
/// some of the least bits of a double even where waves cancel.
inline Spectrum exact_spectrum(View x, View y, int kmax) {
  using Real = long double;
  const auto side = static_cast<std::size_t>(2 * kmax + 1);
  std::vector<Real> real(side * side), imaginary(side * side), cosine(side), sine(side);
  const auto angle = [](int k, double at) {
    const Real turns = static_cast<Real>(k) * at;
    return 2 * std::numbers::pi_v<Real> * (turns - std::round(turns));
  };
  for (std::size_t p = 0; p < x.size(); ++p) {
    for (int k = -kmax; k <= kmax; ++k) {
      cosine[static_cast<std::size_t>(k + kmax)] = std::cos(angle(k, x[p]));
      sine[static_cast<std::size_t>(k + kmax)] = std::sin(angle(k, x[p]));
    }
    for (int k = -kmax; k <= kmax; ++k) {
      const Real c = std::cos(angle(k, y[p])), s = std::sin(angle(k, y[p]));
      const std::size_t row = static_cast<std::size_t>(k + kmax) * side;
      for (std::size_t i = 0; i < side; ++i) {
        real[row + i] += c * cosine[i] - s * sine[i];
        imaginary[row + i] += s * cosine[i] + c * sine[i];
      }
    }
  }
  Spectrum spectrum{kmax, Values(side * side)};
  for (std::size_t k = 0; k < side * side; ++k) {
    spectrum.power[k] = static_cast<double>((real[k] * real[k] + imaginary[k] * imaginary[k]) /
                                            static_cast<Real>(x.size()));
  }
  return spectrum;
}

}  // namespace mc::checks
