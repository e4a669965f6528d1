// mistake: shuffles the strata of x within their columns, and leaves those of y
// caught by: 3.7 each point is uniform in its cell
// hint: x is shuffled and y is not
#include "stratification.hpp"
#define multi_jittered right_multi_jittered
#include "solutions/stratification.cpp"
#undef multi_jittered

namespace mc {

void multi_jittered(std::span<double> x, std::span<double> y, Grid grid, Rng& rng) {
  require_grid(x, y, grid);
  const Strata fine(x.size());
  stratified_1d(x, rng);
  for (std::size_t i = 0; i < grid.nx; ++i) {
    shuffle(x.subspan(i * grid.ny, grid.ny), rng);
    for (std::size_t j = 0; j < grid.ny; ++j) {
      y[i * grid.ny + j] = fine.place(static_cast<double>(j * grid.nx + i), to_unit(rng()));
    }
  }
}

}  // namespace mc
