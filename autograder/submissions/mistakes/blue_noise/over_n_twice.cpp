// mistake: divides the sum by N, squares, and divides by N
// caught by: 4.4 random points by the definition
// caught by: 4.4 spectra that are known exactly
// caught by: 4.4 jittered points
// hint: this is divided by N twice
#include "blue_noise.hpp"
#define periodogram right_periodogram
#include "solutions/blue_noise.cpp"
#undef periodogram

namespace mc {

void periodogram(std::span<const double> x, std::span<const double> y, int kmax,
                 std::span<double> power) {
  right_periodogram(x, y, kmax, power);

  const auto n = static_cast<double>(x.size());
  for (double& value : power) value /= n;
}

}  // namespace mc
