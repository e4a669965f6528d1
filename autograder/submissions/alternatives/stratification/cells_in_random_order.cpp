// alternative: the cells of a jittered grid are visited in random order, by std::shuffle, which
// never ends with a generator of one word
#include "stratification.hpp"
#define stratified_2d right_stratified_2d
#include "solutions/stratification.cpp"

#include <algorithm>
#include <numeric>
#undef stratified_2d

namespace mc {

void stratified_2d(std::span<double> x, std::span<double> y, Grid grid, Rng& rng) {
  require_grid(x, y, grid);
  std::vector<std::size_t> cells(x.size());
  std::iota(cells.begin(), cells.end(), std::size_t{0});
  std::shuffle(cells.begin(), cells.end(), rng);
  for (std::size_t k = 0; k < cells.size(); ++k) {
    x[k] = definition::in_stratum(cells[k] % grid.nx, grid.nx, to_unit(rng()));
    y[k] = definition::in_stratum(cells[k] / grid.nx, grid.ny, to_unit(rng()));
  }
}

}  // namespace mc
