// mistake: shuffles x and y of a pattern each into an order of its own
// caught by: 3.4 every pair of dimensions is a jittered grid
// caught by: 3.4 patterns are shuffled independently
// caught by: 3.4 long patterns have no trend
// caught by: 3.4 the first n of N are a fair sample
// hint: x and y of a point belong together
#include "stratification.hpp"
#define stratified right_stratified
#include "solutions/stratification.cpp"
#undef stratified

namespace mc {

void stratified(PointSet& points, Rng& rng) {
  right_stratified(points, rng);
  for (std::size_t d = 0; d < points.dims(); ++d) shuffle(points.column(d), rng);
}

}  // namespace mc
