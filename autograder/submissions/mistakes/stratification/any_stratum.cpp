// mistake: each point goes to a random stratum: some get two, some none
// caught by: 3.1 one point in each stratum and in order
// caught by: 3.1 each point is uniform in its stratum
// caught by: 3.1 the strata are independent of each other
// caught by: 3.1 the error falls as N^-1.5
// caught by: 3.1 a wave in each stratum gains nothing
// caught by: 3.1 no point leaves its stratum whatever the bits
// hint: one point in each stratum
#include "stratification.hpp"
#define stratified_1d right_stratified_1d
#include "solutions/stratification.cpp"
#undef stratified_1d

namespace mc {

void stratified_1d(std::span<double> x, Rng& rng) {
  std::vector<double> places(x.size());
  right_stratified_1d(places, rng);
  for (double& value : x) value = places[rng() % places.size()];
  std::sort(x.begin(), x.end());
}

}  // namespace mc
