// mistake: one random number moves the points of all strata
// caught by: 3.1 each point is uniform in its stratum
// caught by: 3.1 the strata are independent of each other
// caught by: 3.1 the error falls as N^-1.5
// caught by: 3.1 a wave in each stratum gains nothing
// hint: the same random numbers come again and again
#include "stratification.hpp"

#include <cmath>

#define stratified_1d right_stratified_1d
#include "solutions/stratification.cpp"
#undef stratified_1d

namespace mc {

void stratified_1d(std::span<double> x, Rng& rng) {
  const double u = to_unit(rng());
  const auto n = static_cast<double>(x.size());
  for (std::size_t i = 0; i < x.size(); ++i) {
    x[i] = std::min((static_cast<double>(i) + u) / n,
                    std::nextafter(static_cast<double>(i + 1) / n, 0.0));
  }
}

}  // namespace mc
