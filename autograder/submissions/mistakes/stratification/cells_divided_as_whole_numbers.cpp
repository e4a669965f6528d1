// mistake: divides i by nx, j by ny as whole numbers, which gives 0
// caught by: 3.3 one point in each cell
// caught by: 3.3 the cells are independent of each other
// caught by: 3.3 the error falls as 1/N in the plane
// caught by: 3.3 the error falls as N^-3/4 across an edge
// caught by: 3.3 edges and waves and a corner have their exact variances
// caught by: 3.3 no point leaves its cell whatever the bits
// hint: every point lies in cell (0, 0)
#include "stratification.hpp"
#define stratified_2d right_stratified_2d
#include "solutions/stratification.cpp"
#undef stratified_2d

namespace mc {

void stratified_2d(std::span<double> x, std::span<double> y, Grid grid, Rng& rng) {
  require_grid(x, y, grid);
  for (std::size_t k = 0; k < x.size(); ++k) {
    const std::size_t i = k % grid.nx, j = k / grid.nx;
    x[k] = static_cast<double>(i / grid.nx) + to_unit(rng()) / static_cast<double>(grid.nx);
    y[k] = static_cast<double>(j / grid.ny) + to_unit(rng()) / static_cast<double>(grid.ny);
  }
}

}  // namespace mc
