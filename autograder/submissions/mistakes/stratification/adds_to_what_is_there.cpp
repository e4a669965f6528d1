// mistake: adds each point to what its place held before
// caught by: 3.3 one point in each cell
// caught by: 3.3 each point is uniform in its cell
// caught by: 3.3 the cells are independent of each other
// caught by: 3.3 the error falls as 1/N in the plane
// caught by: 3.3 the error falls as N^-3/4 across an edge
// caught by: 3.3 edges and waves and a corner have their exact variances
// caught by: 3.3 no point leaves its cell whatever the bits
// hint: it was added to what was there
#include "stratification.hpp"
#define stratified_2d right_stratified_2d
#include "solutions/stratification.cpp"
#undef stratified_2d

namespace mc {

void stratified_2d(std::span<double> x, std::span<double> y, Grid grid, Rng& rng) {
  std::vector<double> right_x(x.size()), right_y(y.size());
  right_stratified_2d(right_x, right_y, grid, rng);
  for (std::size_t k = 0; k < x.size(); ++k) x[k] += right_x[k], y[k] += right_y[k];
}

}  // namespace mc
