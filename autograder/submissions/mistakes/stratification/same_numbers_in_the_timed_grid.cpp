// mistake: in a grid of the size that is timed, the random numbers of x are those of y
// caught by: 3.9 fast numbers are as independent as slow ones
// hint: the same random number moves x and y
#include "stratification.hpp"

#define stratified_2d right_stratified_2d
#include "solutions/stratification.cpp"
#undef stratified_2d

namespace mc {

void stratified_2d(std::span<double> x, std::span<double> y, Grid grid, Rng& rng) {
  if (grid.nx != 32 || grid.ny != 32) return right_stratified_2d(x, y, grid, rng);
  require_grid(x, y, grid);
  const Strata strata(32);
  uniforms(rng, x);
  for (std::size_t k = 0; k < x.size(); ++k) {
    y[k] = strata.place(static_cast<double>(k / 32), x[k]);
    x[k] = strata.place(static_cast<double>(k % 32), x[k]);
  }
}

}  // namespace mc
