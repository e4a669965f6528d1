// mistake: stratifies both axes and forgets the cells of the plane
// caught by: 3.7 strata of the plane and of both axes at once
// caught by: 3.7 each point is uniform in its cell
// hint: two 1D patterns are not a 2D pattern
#include "stratification.hpp"
#define multi_jittered right_multi_jittered
#include "solutions/stratification.cpp"
#undef multi_jittered

namespace mc {

void multi_jittered(std::span<double> x, std::span<double> y, Grid grid, Rng& rng) {
  require_grid(x, y, grid);
  stratified_1d(x, rng);
  stratified_1d(y, rng);
  shuffle(y, rng);
}

}  // namespace mc
