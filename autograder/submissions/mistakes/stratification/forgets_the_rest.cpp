// mistake: moves whole vectors of eight to their strata and forgets the rest
// caught by: 3.3 one point in each cell
// caught by: 3.3 no point leaves its cell whatever the bits
// hint: gets one point
#include "stratification.hpp"
#define stratified_2d right_stratified_2d
#include "solutions/stratification.cpp"
#undef stratified_2d

namespace mc {

void stratified_2d(std::span<double> x, std::span<double> y, Grid grid, Rng& rng) {
  right_stratified_2d(x, y, grid, rng);
  for (std::size_t k = x.size() / 256 * 256; x.size() > 256 && k < x.size(); ++k) {
    x[k] = to_unit(rng());
  }
}

}  // namespace mc
