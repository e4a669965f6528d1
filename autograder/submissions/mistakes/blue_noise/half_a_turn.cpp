// mistake: forgets the 2 in 2 pi
// caught by: 4.4 random points by the definition
// caught by: 4.4 spectra that are known exactly
// caught by: 4.4 jittered points
// hint: the angle is 2 pi k x
#include "blue_noise.hpp"
#define periodogram right_periodogram
#include "solutions/blue_noise.cpp"
#undef periodogram

namespace mc {

void periodogram(std::span<const double> x, std::span<const double> y, int kmax,
                 std::span<double> power) {
  right_periodogram(x, y, kmax, power);  // for its exceptions
  std::size_t k = 0;
  for (int ky = -kmax; ky <= kmax; ++ky) {
    for (int kx = -kmax; kx <= kmax; ++kx, ++k) {
      double real = 0, imaginary = 0;
      for (std::size_t p = 0; p < x.size(); ++p) {
        const double angle = std::numbers::pi * (kx * x[p] + ky * y[p]);
        real += std::cos(angle);
        imaginary -= std::sin(angle);
      }
      power[k] = (real * real + imaginary * imaginary) / static_cast<double>(x.size());
    }
  }
}

}  // namespace mc
