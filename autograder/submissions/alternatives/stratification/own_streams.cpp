// alternative: each axis draws from its own generator, which is seeded from the one that is
// passed in; strata are cut as low + u (high - low), odd rows of cells go from
// right to left

#include "stratification.hpp"

#include <algorithm>
#include <cmath>

#define stratified_1d right_stratified_1d
#define stratified_2d right_stratified_2d
#include "solutions/stratification.cpp"
#undef stratified_1d
#undef stratified_2d

namespace mc {
namespace {

double between_edges(std::size_t i, std::size_t n, Rng& rng) {
  const double low = static_cast<double>(i) / static_cast<double>(n);
  const double high = static_cast<double>(i + 1) / static_cast<double>(n);
  return std::min(low + to_unit(rng()) * (high - low), std::nextafter(high, low));
}

}  // namespace

void stratified_1d(std::span<double> x, Rng& rng) {
  Rng mine(rng());
  for (std::size_t i = 0; i < x.size(); ++i) x[i] = between_edges(i, x.size(), mine);
}

void stratified_2d(std::span<double> x, std::span<double> y, Grid grid, Rng& rng) {
  require_grid(x, y, grid);
  Rng for_x(rng()), for_y(rng() ^ 1);
  for (std::size_t k = 0; k < x.size(); ++k) {
    const std::size_t j = k / grid.nx, along = k % grid.nx;
    const std::size_t i = j % 2 == 0 ? along : grid.nx - 1 - along;
    x[k] = between_edges(i, grid.nx, for_x);
    y[k] = between_edges(j, grid.ny, for_y);
  }
}

}  // namespace mc
