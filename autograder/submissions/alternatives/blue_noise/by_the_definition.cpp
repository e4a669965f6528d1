// alternative: the periodogram by its definition, a complex exponential for each term; rings by
// comparing squares
#include "blue_noise.hpp"
#define periodogram fast_periodogram  // also in `definition`
#define radial_power right_radial_power
#include "solutions/blue_noise.cpp"

#include <limits>
#undef periodogram
#undef radial_power

namespace mc {

void periodogram(std::span<const double> x, std::span<const double> y, int kmax,
                 std::span<double> power) {
  require_pairs(x.size(), y.size());
  require_square(power.size(), kmax);
  definition::fast_periodogram(x, y, kmax, power);
}

std::vector<double> radial_power(std::span<const double> power, int kmax) {
  require_square(power.size(), kmax);
  std::vector<double> rings{std::numeric_limits<double>::quiet_NaN()};
  for (int ring = 1; ring <= kmax; ++ring) {
    double sum = 0, count = 0;
    std::size_t i = 0;
    for (int ky = -kmax; ky <= kmax; ++ky) {
      for (int kx = -kmax; kx <= kmax; ++kx, ++i) {
        const int twice = 4 * (kx * kx + ky * ky);  // (2 abs(k))^2, between two odd squares
        if (twice < (2 * ring - 1) * (2 * ring - 1) || twice > (2 * ring + 1) * (2 * ring + 1))
          continue;
        sum += power[i];
        ++count;
      }
    }
    rings.push_back(sum / count);
  }
  return rings;
}

}  // namespace mc
