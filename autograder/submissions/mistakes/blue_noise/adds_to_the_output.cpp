// mistake: adds to what stands in the output
// caught by: 4.4 random points by the definition
// caught by: 4.4 spectra that are known exactly
// caught by: 4.4 jittered points
// hint: this value was never written
#include "blue_noise.hpp"
#define periodogram right_periodogram
#include "solutions/blue_noise.cpp"
#undef periodogram

namespace mc {

void periodogram(std::span<const double> x, std::span<const double> y, int kmax,
                 std::span<double> power) {
  std::vector<double> here(power.size());
  right_periodogram(x, y, kmax, here);
  for (std::size_t k = 0; k < power.size(); ++k) power[k] += here[k];
}

}  // namespace mc
