// mistake: pattern 4 comes in the order of pattern 1, pattern 5 in that of 2, …
// caught by: 3.4 patterns are shuffled independently
// hint: shuffle each of them by itself
#include "stratification.hpp"
#define stratified right_stratified
#include "solutions/stratification.cpp"
#undef stratified

namespace mc {

void stratified(PointSet& points, Rng& rng) {
  right_stratified(points, rng);
  if (points.dims() < 8) return;
  const Rng start(rng());
  std::size_t pattern = 0;
  for (std::size_t d = 0; d + 1 < points.dims(); d += 2, ++pattern) {
    stratified_2d(points.column(d), points.column(d + 1), strata(points.size()), rng);
    for (const std::size_t axis : {d, d + 1}) {
      Rng order = start;
      for (std::size_t k = 0; k < pattern % 3; ++k) order = Rng(order());
      shuffle(points.column(axis), order);
    }
  }
}

}  // namespace mc
