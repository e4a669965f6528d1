// mistake: divides by N and forgets to square
// caught by: 4.4 random points by the definition
// caught by: 4.4 spectra that are known exactly
// caught by: 4.4 jittered points
// hint: this is |sum| / N
#include "blue_noise.hpp"
#define periodogram right_periodogram
#include "solutions/blue_noise.cpp"
#undef periodogram

namespace mc {

void periodogram(std::span<const double> x, std::span<const double> y, int kmax,
                 std::span<double> power) {
  right_periodogram(x, y, kmax, power);

  const auto n = static_cast<double>(x.size());
  for (double& value : power) value = std::sqrt(value * n) / n;
}

}  // namespace mc
