// mistake: shuffles x and y of multi-jittered points apart
// caught by: 3.7 strata of the plane and of both axes at once
// caught by: 3.7 each point is uniform in its cell
// hint: nor is one whose x and y were shuffled apart
#include "stratification.hpp"
#define multi_jittered right_multi_jittered
#include "solutions/stratification.cpp"
#undef multi_jittered

namespace mc {

void multi_jittered(std::span<double> x, std::span<double> y, Grid grid, Rng& rng) {
  right_multi_jittered(x, y, grid, rng);
  shuffle(x, rng);
  shuffle(y, rng);
}

}  // namespace mc
