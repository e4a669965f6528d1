// mistake: all calls share one generator of their own, which no seed reaches
// caught by: 3.3 one point in each cell
// hint: is the same in a set of another seed
#include "stratification.hpp"
#define stratified_2d right_stratified_2d
#include "solutions/stratification.cpp"
#undef stratified_2d

namespace mc {

void stratified_2d(std::span<double> x, std::span<double> y, Grid grid, Rng& rng) {
  (void)rng;
  static Rng mine(1);
  right_stratified_2d(x, y, grid, mine);
}

}  // namespace mc
