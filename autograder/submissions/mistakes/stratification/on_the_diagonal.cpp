// mistake: the same random number moves x and y
// caught by: 3.3 each point is uniform in its cell
// caught by: 3.3 the error falls as 1/N in the plane
// caught by: 3.3 the error falls as N^-3/4 across an edge
// caught by: 3.3 edges and waves and a corner have their exact variances
// hint: the same random number moves x and y
#include "stratification.hpp"
#define stratified_2d right_stratified_2d
#include "solutions/stratification.cpp"
#undef stratified_2d

namespace mc {

void stratified_2d(std::span<double> x, std::span<double> y, Grid grid, Rng& rng) {
  require_grid(x, y, grid);
  const Strata columns(grid.nx), rows(grid.ny);
  for (std::size_t k = 0; k < x.size(); ++k) {
    const double u = to_unit(rng());
    x[k] = columns.place(static_cast<double>(k % grid.nx), u);
    y[k] = rows.place(static_cast<double>(k / grid.nx), u);
  }
}

}  // namespace mc
