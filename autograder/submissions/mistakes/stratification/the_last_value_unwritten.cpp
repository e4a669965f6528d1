// mistake: a loop that ends one too early: the last point is never written
// caught by: 3.1 one point in each stratum and in order
// caught by: 3.1 each point is uniform in its stratum
// caught by: 3.1 the strata are independent of each other
// caught by: 3.1 the error falls as N^-1.5
// caught by: 3.1 a wave in each stratum gains nothing
// caught by: 3.1 no point leaves its stratum whatever the bits
// hint: values were never written
#include "stratification.hpp"
#define stratified_1d right_stratified_1d
#include "solutions/stratification.cpp"
#undef stratified_1d

namespace mc {

void stratified_1d(std::span<double> x, Rng& rng) {
  const Strata strata(x.size());
  for (std::size_t i = 0; i + 1 < x.size(); ++i) {
    x[i] = strata.place(static_cast<double>(i), to_unit(rng()));
  }
}

}  // namespace mc
