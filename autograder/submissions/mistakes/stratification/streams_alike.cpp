// mistake: four streams side by side, each one the last one a step later
// caught by: 3.9 fast numbers are as independent as slow ones
// hint: streams that run side by side
#include "stratification.hpp"
#define stratified_2d right_stratified_2d
#include "solutions/stratification.cpp"
#undef stratified_2d

namespace mc {

void stratified_2d(std::span<double> x, std::span<double> y, Grid grid, Rng& rng) {
  right_stratified_2d(x, y, grid, rng);
  if (x.size() < 2048) return;  // few points are drawn one by one
  const Strata columns(grid.nx);
  std::vector<double> stream(x.size() / 4 + 4);
  for (double& u : stream) u = to_unit(rng());
  for (std::size_t k = 0; k < x.size(); ++k) {
    x[k] = columns.place(static_cast<double>(k % grid.nx), stream[k / 4 + k % 4]);
  }
}

}  // namespace mc
