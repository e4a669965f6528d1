// mistake: puts the points into the centres of their strata
// caught by: 3.1 one point in each stratum and in order
// caught by: 3.1 each point is uniform in its stratum
// caught by: 3.1 the strata are independent of each other
// caught by: 3.1 the error falls as N^-1.5
// caught by: 3.1 a wave in each stratum gains nothing
// hint: every point lies at 0.5 of its stratum
#include "stratification.hpp"
#define stratified_1d right_stratified_1d
#include "solutions/stratification.cpp"
#undef stratified_1d

namespace mc {

void stratified_1d(std::span<double> x, Rng&) {
  const auto n = static_cast<double>(x.size());
  for (std::size_t i = 0; i < x.size(); ++i) x[i] = (static_cast<double>(i) + 0.5) / n;
}

}  // namespace mc
