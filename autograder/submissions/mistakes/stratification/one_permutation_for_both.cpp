// mistake: columns and rows of a square grid share one permutation
// caught by: 3.7 each point is uniform in its cell
// hint: random permutations, all of them equally likely
#include "stratification.hpp"
#define multi_jittered right_multi_jittered
#include "solutions/stratification.cpp"
#undef multi_jittered

namespace mc {

void multi_jittered(std::span<double> x, std::span<double> y, Grid grid, Rng& rng) {
  if (grid.nx != grid.ny) return right_multi_jittered(x, y, grid, rng);
  require_grid(x, y, grid);
  std::vector<double> order(grid.nx);
  std::iota(order.begin(), order.end(), 0.0);
  shuffle(order, rng);
  const Strata fine(x.size());
  for (std::size_t k = 0; k < x.size(); ++k) {
    const std::size_t i = k % grid.nx, j = k / grid.nx;
    x[k] = fine.place(static_cast<double>(i * grid.ny) + order[j], to_unit(rng()));
    y[k] = fine.place(static_cast<double>(j * grid.nx) + order[i], to_unit(rng()));
  }
}

}  // namespace mc
