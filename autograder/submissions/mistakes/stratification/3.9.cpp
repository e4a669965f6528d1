// Mistakes in task 3.9.
#include "stratification.hpp"

#define stratified_2d right_stratified_2d
#include "solutions/stratification.cpp"
#undef stratified_2d

// mistake: uses the random numbers of x for y, in a grid of the size that is timed
// hint: the jitter of x in cell 0 and the jitter of y in cell 0 share one random number
namespace mc::same_numbers_in_the_timed_grid {
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
}  // namespace mc::same_numbers_in_the_timed_grid

// mistake: runs four streams, each of which repeats the previous one a step later
// hint: blocks or streams begin in the same state
namespace mc::streams_alike {
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
}  // namespace mc::streams_alike
