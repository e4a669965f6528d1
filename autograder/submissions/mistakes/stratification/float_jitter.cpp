// mistake: jitter of 24 random bits, as a float has
// caught by: 3.3 each point is uniform in its cell
// hint: the random numbers have too few bits
#include "stratification.hpp"
#define stratified_2d right_stratified_2d
#include "solutions/stratification.cpp"
#undef stratified_2d

namespace mc {

void stratified_2d(std::span<double> x, std::span<double> y, Grid grid, Rng& rng) {
  require_grid(x, y, grid);
  const auto jitter = [&] { return static_cast<float>(rng() >> 40) * 0x1p-24f; };
  const Strata columns(grid.nx), rows(grid.ny);
  for (std::size_t k = 0; k < x.size(); ++k) {
    x[k] = columns.place(static_cast<double>(k % grid.nx), jitter());
    y[k] = rows.place(static_cast<double>(k / grid.nx), jitter());
  }
}

}  // namespace mc
