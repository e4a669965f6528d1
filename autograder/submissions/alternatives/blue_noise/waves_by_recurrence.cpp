// alternative: the periodogram by a recurrence: each wave is the one before, turned by the point
#include "blue_noise.hpp"
#define periodogram right_periodogram
#include "solutions/blue_noise.cpp"

#include <cmath>
#undef periodogram

namespace mc {

void periodogram(std::span<const double> x, std::span<const double> y, int kmax,
                 std::span<double> power) {
  require_pairs(x.size(), y.size());
  const std::size_t side = require_square(power.size(), kmax);
  std::vector<double> real(side * side), imaginary(side * side);
  for (std::size_t p = 0; p < x.size(); ++p) {
    const double turn = 2 * std::numbers::pi * x[p];
    const double c = std::cos(turn), s = std::sin(turn);
    for (std::size_t j = 0; j < side; ++j) {
      const double ky = static_cast<double>(j) - kmax;
      const double first = 2 * std::numbers::pi * (ky * y[p] - kmax * x[p]);
      double wave_real = std::cos(first), wave_imaginary = std::sin(first);
      for (std::size_t i = 0; i < side; ++i) {
        real[j * side + i] += wave_real;
        imaginary[j * side + i] += wave_imaginary;
        const double turned = wave_real * c - wave_imaginary * s;
        wave_imaginary = wave_real * s + wave_imaginary * c;
        wave_real = turned;
      }
    }
  }
  for (std::size_t k = 0; k < power.size(); ++k) {
    power[k] = (real[k] * real[k] + imaginary[k] * imaginary[k]) / static_cast<double>(x.size());
  }
}

}  // namespace mc
