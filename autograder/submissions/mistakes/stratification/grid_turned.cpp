// mistake: nx cells along y and ny along x
// caught by: 3.3 one point in each cell
// caught by: 3.3 no point leaves its cell whatever the bits
// hint: nx and ny have changed places
#include "stratification.hpp"
#define stratified_2d right_stratified_2d
#include "solutions/stratification.cpp"
#undef stratified_2d

namespace mc {

void stratified_2d(std::span<double> x, std::span<double> y, Grid grid, Rng& rng) {
  right_stratified_2d(y, x, grid, rng);
}

}  // namespace mc
