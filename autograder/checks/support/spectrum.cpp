#include "checks/support/spectrum.hpp"

#include <numbers>

namespace mc::checks {
namespace {

/// cos and sin of 2 pi k position, for k from 0 on.
struct Waves {
  std::vector<double> cosine, sine;

  explicit Waves(std::size_t count) : cosine(count), sine(count) {}

  void at(double position) {
    const double c = std::cos(2 * std::numbers::pi * position);
    const double s = std::sin(2 * std::numbers::pi * position);
    cosine[0] = 1;
    sine[0] = 0;
    for (std::size_t k = 1; k < cosine.size(); ++k) {
      cosine[k] = cosine[k - 1] * c - sine[k - 1] * s;
      sine[k] = sine[k - 1] * c + cosine[k - 1] * s;
    }
  }
};

}  // namespace

Spectrum spectrum_of(std::span<const double> x, std::span<const double> y, int kmax) {
  const auto count = static_cast<std::size_t>(kmax) + 1;
  Waves along(count), up(count);
  // Sums of cos cos, sin sin, sin cos, cos sin over the points, for k = (kx, ky) and (-kx, ky).
  std::vector<double> cc(count * count), ss(cc), sc(cc), cs(cc);
  for (std::size_t p = 0; p < x.size(); ++p) {
    along.at(x[p]);
    up.at(y[p]);
    for (std::size_t ky = 0; ky < count; ++ky) {
      const double c = up.cosine[ky], s = up.sine[ky];
      const double *const cosine = along.cosine.data(), *const sine = along.sine.data();
      double *const to_cc = &cc[ky * count], *const to_ss = &ss[ky * count];
      double *const to_sc = &sc[ky * count], *const to_cs = &cs[ky * count];
      for (std::size_t kx = 0; kx < count; ++kx) {
        to_cc[kx] += cosine[kx] * c;
        to_ss[kx] += sine[kx] * s;
        to_sc[kx] += sine[kx] * c;
        to_cs[kx] += cosine[kx] * s;
      }
    }
  }
  Spectrum spectrum{kmax, std::vector<double>((2 * count - 1) * (2 * count - 1))};
  const auto set = [&](std::size_t column, std::size_t row, double real, double imaginary) {
    const std::size_t at = row * (2 * count - 1) + column;
    spectrum.power[at] = (real * real + imaginary * imaginary) / static_cast<double>(x.size());
    spectrum.power[spectrum.power.size() - 1 - at] = spectrum.power[at];  // at -k
  };
  for (std::size_t ky = 0; ky < count; ++ky) {
    for (std::size_t kx = 0; kx < count; ++kx) {
      const std::size_t i = ky * count + kx, middle = count - 1;
      set(middle + kx, middle + ky, cc[i] - ss[i], sc[i] + cs[i]);
      set(middle - kx, middle + ky, cc[i] + ss[i], cs[i] - sc[i]);
    }
  }
  return spectrum;
}

}  // namespace mc::checks
