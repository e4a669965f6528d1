// mistake: fills the cells of the plane and forgets the strata of the axes
// caught by: 3.7 strata of the plane and of both axes at once
// caught by: 3.7 each point is uniform in its strata of x and y
// caught by: 3.7 a sum is estimated as in one dimension
// hint: a column of cells has ny strata of x
#include "stratification.hpp"
#define multi_jittered right_multi_jittered
#include "solutions/stratification.cpp"
#undef multi_jittered

namespace mc {

void multi_jittered(std::span<double> x, std::span<double> y, Grid grid, Rng& rng) {
  stratified_2d(x, y, grid, rng);
}

}  // namespace mc
