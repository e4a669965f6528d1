// mistake: takes the power at k = 0 out
// caught by: 4.4 spectra that are known exactly
// caught by: 4.4 random points by the definition
// hint: k = 0 is power like any other
#include "blue_noise.hpp"
#define periodogram right_periodogram
#include "solutions/blue_noise.cpp"
#undef periodogram

namespace mc {

void periodogram(std::span<const double> x, std::span<const double> y, int kmax,
                 std::span<double> power) {
  right_periodogram(x, y, kmax, power);
  const auto n = static_cast<double>(x.size());
  if (n > 0) power[power.size() / 2] = 0;
}

}  // namespace mc
