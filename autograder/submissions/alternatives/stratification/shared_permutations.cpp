// alternative: correlated multi-jittering, after Kensler: all columns share one permutation, all
// rows another one

#include "stratification.hpp"
#define multi_jittered right_multi_jittered
#include "solutions/stratification.cpp"
#undef multi_jittered

namespace mc {

void multi_jittered(std::span<double> x, std::span<double> y, Grid grid, Rng& rng) {
  require_grid(x, y, grid);
  std::vector<double> in_column(grid.ny), in_row(grid.nx);
  for (std::size_t j = 0; j < grid.ny; ++j) in_column[j] = static_cast<double>(j);
  for (std::size_t i = 0; i < grid.nx; ++i) in_row[i] = static_cast<double>(i);
  shuffle(in_column, rng);
  shuffle(in_row, rng);
  const Strata fine(x.size());
  for (std::size_t j = 0; j < grid.ny; ++j) {
    for (std::size_t i = 0; i < grid.nx; ++i) {
      const std::size_t k = j * grid.nx + i;
      x[k] = fine.place(static_cast<double>(i * grid.ny) + in_column[j], to_unit(rng()));
      y[k] = fine.place(static_cast<double>(j * grid.nx) + in_row[i], to_unit(rng()));
    }
  }
}

}  // namespace mc
