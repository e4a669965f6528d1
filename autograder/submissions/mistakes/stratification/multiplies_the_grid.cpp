// mistake: compares nx * ny with the size in 64 bits, where it wraps around
// caught by: 3.3 what is no grid of these points is refused
// hint: divide instead
#include "stratification.hpp"
#define stratified_2d right_stratified_2d
#include "solutions/stratification.cpp"
#undef stratified_2d

namespace mc {

void stratified_2d(std::span<double> x, std::span<double> y, Grid grid, Rng& rng) {
  if (x.size() != y.size()) throw std::invalid_argument("x and y: sizes differ");
  if (grid.nx * grid.ny != x.size() || x.empty()) {
    throw std::invalid_argument("grid: nx * ny is not the number of points");
  }
  if (x.size() % grid.nx == 0) return right_stratified_2d(x, y, grid, rng);
  for (std::size_t k = 0; k < x.size(); ++k) x[k] = y[k] = to_unit(rng());
}

}  // namespace mc
