// alternative: multi-jittering as Chiu, Shirley and Wang have it: every column and every row of
// cells has a permutation of its own

#include "stratification.hpp"
#define multi_jittered right_multi_jittered
#include "solutions/stratification.cpp"
#undef multi_jittered

namespace mc {

void multi_jittered(std::span<double> x, std::span<double> y, Grid grid, Rng& rng) {
  require_grid(x, y, grid);
  std::vector<double> by_row(y.size());
  stratified_1d(x, rng);
  stratified_1d(by_row, rng);
  for (std::size_t i = 0; i < grid.nx; ++i) shuffle(x.subspan(i * grid.ny, grid.ny), rng);
  for (std::size_t j = 0; j < grid.ny; ++j) {
    shuffle(std::span(by_row).subspan(j * grid.nx, grid.nx), rng);
  }
  for (std::size_t i = 0; i < grid.nx; ++i) {  // x goes by columns, so y must too
    for (std::size_t j = 0; j < grid.ny; ++j) y[i * grid.ny + j] = by_row[j * grid.nx + i];
  }
}

}  // namespace mc
