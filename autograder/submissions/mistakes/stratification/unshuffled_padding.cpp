// mistake: puts the patterns side by side as they come
// caught by: 3.4 patterns are shuffled independently
// caught by: 3.4 long patterns have no trend
// caught by: 3.4 the first n of N are a fair sample
// hint: shuffle each of them by itself
#include "stratification.hpp"
#define stratified right_stratified
#include "solutions/stratification.cpp"
#undef stratified

namespace mc {

void stratified(PointSet& points, Rng& rng) {
  std::size_t d = 0;
  for (; d + 1 < points.dims(); d += 2) {
    stratified_2d(points.column(d), points.column(d + 1), strata(points.size()), rng);
  }
  if (d < points.dims()) stratified_1d(points.column(d), rng);
}

}  // namespace mc
