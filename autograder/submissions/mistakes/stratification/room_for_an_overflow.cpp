// mistake: compares nx * ny in 64 bits, and makes room for nx columns
// caught by: 3.7 what is no grid of these points is refused
// hint: the product of 64-bit numbers wraps around
#include "stratification.hpp"
#define multi_jittered right_multi_jittered
#include "solutions/stratification.cpp"
#undef multi_jittered

namespace mc {

void multi_jittered(std::span<double> x, std::span<double> y, Grid grid, Rng& rng) {
  if (x.size() != y.size()) throw std::invalid_argument("x and y: sizes differ");
  if (grid.nx * grid.ny != x.size() || x.empty()) {
    throw std::invalid_argument("grid: nx * ny is not the number of points");
  }
  const std::vector<double> columns(grid.nx);
  right_multi_jittered(x, y, grid, rng);
}

}  // namespace mc
