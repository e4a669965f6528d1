// mistake: exchanges kx and ky
// caught by: 4.4 spectra that are known exactly
// caught by: 4.4 random points by the definition
// hint: kx and ky are exchanged
#include "blue_noise.hpp"
#define periodogram right_periodogram
#include "solutions/blue_noise.cpp"
#undef periodogram

namespace mc {

void periodogram(std::span<const double> x, std::span<const double> y, int kmax,
                 std::span<double> power) {
  right_periodogram(x, y, kmax, power);
  const auto n = static_cast<double>(x.size());
  if (n < 1) return;
  const auto side = static_cast<std::size_t>(2 * kmax + 1);
  for (std::size_t j = 0; j < side; ++j) {
    for (std::size_t i = 0; i < j; ++i) std::swap(power[j * side + i], power[i * side + j]);
  }
}

}  // namespace mc
