// mistake: jitter of 8 random bits: one of 256 places in each stratum
// caught by: 3.1 each point is uniform in its stratum
// hint: the random numbers have too few bits
#include "stratification.hpp"

#include <cmath>

#define stratified_1d right_stratified_1d
#include "solutions/stratification.cpp"
#undef stratified_1d

namespace mc {

void stratified_1d(std::span<double> x, Rng& rng) {
  const auto n = static_cast<double>(x.size());
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double u = static_cast<double>(rng() >> 56) / 256;
    const double edge = static_cast<double>(i + 1) / n;
    x[i] = std::min((static_cast<double>(i) + u) / n, std::nextafter(edge, 0.0));
  }
}

}  // namespace mc
