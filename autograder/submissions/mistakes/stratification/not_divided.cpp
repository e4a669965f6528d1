// mistake: i + u without the division by N
// caught by: 3.1 one point in each stratum and in order
// caught by: 3.1 each point is uniform in its stratum
// caught by: 3.1 the strata are independent of each other
// caught by: 3.1 the error falls as N^-1.5
// caught by: 3.1 a wave in each stratum gains nothing
// caught by: 3.1 no point leaves its stratum whatever the bits
// hint: divide by the number of strata
#include "stratification.hpp"
#define stratified_1d right_stratified_1d
#include "solutions/stratification.cpp"
#undef stratified_1d

namespace mc {

void stratified_1d(std::span<double> x, Rng& rng) {
  for (std::size_t i = 0; i < x.size(); ++i) x[i] = static_cast<double>(i) + to_unit(rng());
}

}  // namespace mc
