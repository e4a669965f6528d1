// mistake: refuses what is no grid, in words that name nothing
// caught by: 3.3 the refusals name the argument
// hint: say in the exception
#include "stratification.hpp"
#define stratified_2d right_stratified_2d
#include "solutions/stratification.cpp"
#undef stratified_2d

namespace mc {

void stratified_2d(std::span<double> x, std::span<double> y, Grid grid, Rng& rng) {
  if (x.size() != y.size() || grid.nx == 0 || x.size() % grid.nx != 0 ||
      x.size() / grid.nx != grid.ny || grid.ny == 0) {
    throw std::invalid_argument("no");
  }
  right_stratified_2d(x, y, grid, rng);
}

}  // namespace mc
