// mistake: x is jittered once for each column of cells, y once for each row
// caught by: 3.3 each point is uniform in its cell
// caught by: 3.3 the cells are independent of each other
// caught by: 3.3 the error falls as 1/N in the plane
// caught by: 3.3 the error falls as N^-3/4 across an edge
// caught by: 3.3 edges and waves and a corner have their exact variances
// hint: the same random numbers come again and again
#include "stratification.hpp"
#define stratified_2d right_stratified_2d
#include "solutions/stratification.cpp"
#undef stratified_2d

namespace mc {

void stratified_2d(std::span<double> x, std::span<double> y, Grid grid, Rng& rng) {
  require_grid(x, y, grid);
  std::vector<double> columns(grid.nx), rows(grid.ny);
  stratified_1d(columns, rng);
  stratified_1d(rows, rng);
  for (std::size_t k = 0; k < x.size(); ++k) {
    x[k] = columns[k % grid.nx];
    y[k] = rows[k / grid.nx];
  }
}

}  // namespace mc
