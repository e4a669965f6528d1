// mistake: leaves the canonical arrangement as it is
// caught by: 3.7 each point is uniform in its cell
// hint: this is the canonical arrangement
#include "stratification.hpp"
#define multi_jittered right_multi_jittered
#include "solutions/stratification.cpp"
#undef multi_jittered

namespace mc {

void multi_jittered(std::span<double> x, std::span<double> y, Grid grid, Rng& rng) {
  require_grid(x, y, grid);
  const Strata fine(x.size());
  for (std::size_t i = 0; i < grid.nx; ++i) {
    for (std::size_t j = 0; j < grid.ny; ++j) {
      const std::size_t k = i * grid.ny + j;
      x[k] = fine.place(static_cast<double>(i * grid.ny + j), to_unit(rng()));
      y[k] = fine.place(static_cast<double>(j * grid.nx + i), to_unit(rng()));
    }
  }
}

}  // namespace mc
